// SPDX-License-Identifier: Apache-2.0
// Weights of one slave facet: the integrals of its segments, turned into rows of its multiplier functions.
#pragma once
#include <array>
#include <cstdint>
#include <span>

#include "brunt/contact/data/mortar_pair.hpp"
#include "brunt/contact/mortar/segment.hpp"

namespace brunt::contact {

/// Facets covered by less than this share are left out.
constexpr double least_coverage = 1e-6;
/// Below this share the mass matrix of the covered part is nearly singular; the hats are lumped instead.
constexpr double lumped_coverage = 1e-3;

/// psi_j = sum_k matrix[j][k] N_k on one slave facet.
struct MultiplierFunctions {
  enum class Form : std::int8_t { none, lumped, dual, standard };
  Form form = Form::none;
  int corners = 0;
  std::array<double, 4> share{};                   ///< D_j: sum over segments of int N_j [length^2]
  std::array<std::array<double, 4>, 4> mass{};     ///< M_jk: sum over segments of int N_j N_k [length^2]
  std::array<std::array<double, 4>, 4> matrix{};   ///< A = D M^-1, or the unit matrix
  std::array<std::array<double, 4>, 4> inverse{};  ///< M^-1, where dual [1/length^2]

  /// int psi_j N_k over the covered part: diagonal unless standard.
  [[nodiscard]] double slave_weight(std::size_t j, std::size_t k) const;
  /// int psi_j N_C of one segment.
  [[nodiscard]] double master_weight(std::size_t j, std::size_t c, const SegmentIntegrals& segment) const;
};

/// From all segments of a slave facet.
MultiplierFunctions multiplier_functions(const SlavePlane& plane, std::span<const SegmentIntegrals> segments,
                                         Multiplier multiplier);

/// Derivative of `matrix` in one direction from those of D and M: dA = (dD - A dM) M^-1; zero unless dual.
std::array<std::array<double, 4>, 4> matrix_slope(const MultiplierFunctions& functions,
                                                  const std::array<double, 4>& share_slope,
                                                  const std::array<std::array<double, 4>, 4>& mass_slope);

}  // namespace brunt::contact
