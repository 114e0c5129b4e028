// SPDX-License-Identifier: Apache-2.0
#include "brunt/contact/mortar/weights.hpp"

#include <algorithm>
#include <cmath>

namespace brunt::contact {

namespace {

using Matrix4 = std::array<std::array<double, 4>, 4>;

/// Inverse of the leading n x n part of a symmetric positive definite matrix by Cholesky's factors, which do not suffer
/// from functions of different size; false where a pivot is not positive.
bool invert(const Matrix4& matrix, std::size_t n, Matrix4& inverse) {
  Matrix4 low{}, low_inverse{};
  for (std::size_t j = 0; j < n; ++j)
    for (std::size_t i = j; i < n; ++i) {
      double rest = matrix[i][j];
      for (std::size_t k = 0; k < j; ++k) rest -= low[i][k] * low[j][k];
      if (i == j && !(rest > 0)) return false;
      low[i][j] = i == j ? std::sqrt(rest) : rest / low[j][j];
    }
  for (std::size_t j = 0; j < n; ++j)
    for (std::size_t i = j; i < n; ++i) {
      double rest = i == j ? 1 : 0;
      for (std::size_t k = j; k < i; ++k) rest -= low[i][k] * low_inverse[k][j];
      low_inverse[i][j] = rest / low[i][i];
    }
  inverse = {};
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < n; ++j)
      for (std::size_t k = std::max(i, j); k < n; ++k) inverse[i][j] += low_inverse[k][i] * low_inverse[k][j];
  return true;
}

}  // namespace

double MultiplierFunctions::slave_weight(std::size_t j, std::size_t k) const {
  if (form == Form::standard) return mass[j][k];
  return j == k ? share[j] : 0;
}

double MultiplierFunctions::master_weight(std::size_t j, std::size_t c, const SegmentIntegrals& segment) const {
  double sum = 0;
  for (std::size_t k = 0; k < static_cast<std::size_t>(corners); ++k) sum += matrix[j][k] * segment.master[k][c];
  return sum;
}

MultiplierFunctions multiplier_functions(const SlavePlane& plane, std::span<const SegmentIntegrals> segments,
                                         Multiplier multiplier) {
  using Form = MultiplierFunctions::Form;
  MultiplierFunctions functions;
  functions.corners = plane.corners;
  const auto n = static_cast<std::size_t>(plane.corners);
  double area = 0;
  for (const SegmentIntegrals& segment : segments) {
    area += segment.area;
    for (std::size_t j = 0; j < n; ++j) {
      functions.share[j] += segment.share[j];
      for (std::size_t k = 0; k < n; ++k) functions.mass[j][k] += segment.slave[j][k];
    }
  }
  const double coverage = area / plane.area();
  if (!(coverage >= least_coverage)) return functions;
  for (std::size_t j = 0; j < n; ++j) functions.matrix[j][j] = 1;
  functions.form = Form::standard;
  if (multiplier == Multiplier::standard) return functions;
  functions.form = Form::lumped;
  if (coverage < lumped_coverage || !invert(functions.mass, n, functions.inverse)) return functions;
  functions.form = Form::dual;
  for (std::size_t j = 0; j < n; ++j)
    for (std::size_t k = 0; k < n; ++k) functions.matrix[j][k] = functions.share[j] * functions.inverse[j][k];
  return functions;
}

std::array<std::array<double, 4>, 4> matrix_slope(const MultiplierFunctions& functions,
                                                  const std::array<double, 4>& share_slope,
                                                  const std::array<std::array<double, 4>, 4>& mass_slope) {
  Matrix4 slope{};
  if (functions.form != MultiplierFunctions::Form::dual) return slope;
  const auto n = static_cast<std::size_t>(functions.corners);
  for (std::size_t j = 0; j < n; ++j) {
    std::array<double, 4> rest{};  // row j of dD - A dM
    rest[j] = share_slope[j];
    for (std::size_t k = 0; k < n; ++k)
      for (std::size_t l = 0; l < n; ++l) rest[l] -= functions.matrix[j][k] * mass_slope[k][l];
    for (std::size_t k = 0; k < n; ++k)
      for (std::size_t l = 0; l < n; ++l) slope[j][k] += rest[l] * functions.inverse[l][k];
  }
  return slope;
}

}  // namespace brunt::contact
