// SPDX-License-Identifier: Apache-2.0
// Weights of one slave facet: the integrals of its segments, transformed to its multiplier functions.
#pragma once
#include <array>
#include <cstdint>
#include <span>

#include "contact/data/mortar_pair.hpp"
#include "contact/mortar/segment.hpp"

namespace brunt::contact {

/// Facets with a smaller covered share are ignored.
constexpr double least_coverage = 1e-6;
/// Dual functions of a partly covered facet extrapolate: the gap of a row is then that of its node, which lies outside
/// the overlap, on the planes of the covered part, and separated surfaces may appear closed. Below this share the
/// standard shape functions, which are positive, replace them; between this share and full coverage the dual functions
/// are blended in smoothly.
constexpr double hats_coverage = 0.5;

/// psi_j = sum_k matrix[j][k] N_k on one slave facet.
struct MultiplierFunctions {
  enum class Form : std::int8_t { none, dual, standard };
  Form form = Form::none;
  int corners = 0;
  std::array<double, 4> share{};                ///< D_j: sum over segments of int N_j [length^2]
  std::array<std::array<double, 4>, 4> mass{};  ///< M_jk: sum over segments of int N_j N_k [length^2]
  /// A = dual_share D M^-1 + (1 - dual_share) 1.
  std::array<std::array<double, 4>, 4> matrix{};
  std::array<std::array<double, 4>, 4> inverse{};  ///< M^-1, if dual [1/length^2]
  double area = 0;                                 ///< of the facet [length^2]
  double dual_share = 0, dual_share_slope = 0;     ///< by the covered share of the facet; 1 and 0 if fully covered

  /// int psi_j N_k over the covered part: diagonal if fully dual.
  [[nodiscard]] double slave_weight(std::size_t j, std::size_t k) const;
  /// A without its dual part: dA/d(dual_share) = D M^-1 - 1.
  [[nodiscard]] double dual_part(std::size_t j, std::size_t k) const { return share[j] * inverse[j][k] - (j == k); }
  /// int psi_j N_C of one segment.
  [[nodiscard]] double master_weight(std::size_t j, std::size_t c, const SegmentIntegrals& segment) const;
};

/// From all segments of a slave facet.
MultiplierFunctions multiplier_functions(const SlavePlane& plane, std::span<const SegmentIntegrals> segments,
                                         Multiplier multiplier);

/// Derivative of `matrix` in one direction from those of D, M and the facet's area: with B = D M^-1
/// dB = (dD - B dM) M^-1, dA = dual_share dB + d(dual_share) (B - 1); zero unless dual.
std::array<std::array<double, 4>, 4> matrix_slope(const MultiplierFunctions& functions,
                                                  const std::array<double, 4>& share_slope,
                                                  const std::array<std::array<double, 4>, 4>& mass_slope,
                                                  double area_slope);

/// d(dual_share) in one direction.
double dual_share_slope(const MultiplierFunctions& functions, const std::array<double, 4>& share_slope,
                        double area_slope);

}  // namespace brunt::contact
