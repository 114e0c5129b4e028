// SPDX-License-Identifier: Apache-2.0
#include "contact/mortar/weights.hpp"

#include <algorithm>
#include <cmath>

namespace brunt::contact {

namespace {

using Matrix4 = std::array<std::array<double, 4>, 4>;

/// Inverse of the leading n x n part of a symmetric positive definite matrix by Cholesky's factors, which are accurate
/// for functions of different magnitude; false if a pivot is not positive.
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

/// A cubic between hats_coverage and 1, with zero derivative at both ends.
void blend(double coverage, MultiplierFunctions& functions) {
  constexpr double whole = 1 - 1e-9;  // rounding of the clipped area of a fully covered facet
  functions.dual_share = 1;
  if (coverage >= whole) return;
  constexpr double over = 1 / (1 - hats_coverage);
  const double s = over * (coverage - hats_coverage);
  functions.dual_share = s * s * (3 - 2 * s);
  functions.dual_share_slope = 6 * s * (1 - s) * over;
}

}  // namespace

double MultiplierFunctions::slave_weight(std::size_t j, std::size_t k) const {
  return (j == k ? dual_share * share[j] : 0.0) + (1 - dual_share) * mass[j][k];
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
  functions.area = plane.area();
  const double coverage = area / functions.area;
  if (!(coverage >= least_coverage)) return functions;
  for (std::size_t j = 0; j < n; ++j) functions.matrix[j][j] = 1;
  functions.form = Form::standard;
  if (multiplier == Multiplier::standard || coverage <= hats_coverage || !invert(functions.mass, n, functions.inverse))
    return functions;
  functions.form = Form::dual;
  blend(coverage, functions);
  for (std::size_t j = 0; j < n; ++j)
    for (std::size_t k = 0; k < n; ++k) functions.matrix[j][k] += functions.dual_share * functions.dual_part(j, k);
  return functions;
}

double dual_share_slope(const MultiplierFunctions& functions, const std::array<double, 4>& share_slope,
                        double area_slope) {
  double covered = 0, change = 0;
  for (std::size_t j = 0; j < 4; ++j) {
    covered += functions.share[j];
    change += share_slope[j];
  }
  return functions.dual_share_slope / functions.area * (change - covered / functions.area * area_slope);
}

std::array<std::array<double, 4>, 4> matrix_slope(const MultiplierFunctions& functions,
                                                  const std::array<double, 4>& share_slope,
                                                  const std::array<std::array<double, 4>, 4>& mass_slope,
                                                  double area_slope) {
  Matrix4 slope{};
  if (functions.form != MultiplierFunctions::Form::dual) return slope;
  const auto n = static_cast<std::size_t>(functions.corners);
  const double theta = functions.dual_share, dtheta = dual_share_slope(functions, share_slope, area_slope);
  for (std::size_t j = 0; j < n; ++j) {
    std::array<double, 4> rest{};  // row j of dD - B dM
    rest[j] = share_slope[j];
    for (std::size_t k = 0; k < n; ++k)
      for (std::size_t l = 0; l < n; ++l) rest[l] -= functions.share[j] * functions.inverse[j][k] * mass_slope[k][l];
    for (std::size_t k = 0; k < n; ++k) {
      for (std::size_t l = 0; l < n; ++l) slope[j][k] += theta * rest[l] * functions.inverse[l][k];
      slope[j][k] += dtheta * functions.dual_part(j, k);
    }
  }
  return slope;
}

}  // namespace brunt::contact
