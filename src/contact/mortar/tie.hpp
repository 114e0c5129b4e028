// SPDX-License-Identifier: Apache-2.0
// Tied surfaces: the vector gap of each row, with the weights of the initial configuration, keeps its initial
// components along the unit normals n_f of the slave facets f around its node:
//   c_A = sum_K w_AK x_K - sum_f h_Af n_f(x) = 0.
// Segments are projected along the normals of slave facets, so these components are the whole initial gap. It follows
// every rotation, also about the normal, without a frame of its own. Forces are the transposed derivative of c_A: the
// weights, and the levers of h_Af on the corners of the slave facets.
#pragma once
#include <array>
#include <span>
#include <vector>

#include "contact/mortar/interface.hpp"

namespace brunt::contact {

/// The projection of a slave node onto the master in the initial configuration.
struct MasterPlace {
  FacetNodes nodes{no_index, no_index, no_index, no_index};  ///< the first is no_index if there is no projection
  std::array<double, 4> weights{};                           ///< of the nodes, sum 1
};

struct TieStart {
  NodeBlocks<double> weights;                  ///< w_AK in the tied state [length^2]
  std::vector<double> covered;                 ///< 0: the row is not tied [length^2]
  std::vector<std::array<double, 4>> heights;  ///< h_Af of each slave facet, by corner [length^3]
  bool apart = false;                          ///< whether any height of the whole interface differs from zero
  std::vector<MasterPlace> below;              ///< of each row's node; empty until find_places_below
};

/// rows: of mortar_rows at x. Heights below the rounding of positions are zero.
TieStart tie_start(const MortarSurfaces& surfaces, const Ragged<LocalIndex>& candidates, std::span<const Vec3> x,
                   const MortarRows& rows);

/// Fills TieStart::below. candidates, x: in the initial configuration.
void find_places_below(const MortarSurfaces& surfaces, const MortarTopology& topology,
                       const Ragged<LocalIndex>& candidates, std::span<const Vec3> x, TieStart& start);

/// For each row: projector onto the directions of its multipliers. If supports or walls constrain the slave node along
/// a direction, and also the master at its projection (all nodes with a weight there), a multiplier would be redundant,
/// as at nodes of a plane of symmetry. If the master is free there, it is tied to the prescribed motion of the slave
/// node. Zero for rows that are not tied. free: projector onto the free directions of each node.
std::vector<Mat3> tied_directions(const MortarSurfaces& surfaces, const TieStart& start, std::span<const Mat3> free);

/// Sum of the projectors onto the free directions of the nodes with a weight in a projection; all directions if there
/// is no projection.
Mat3 freedom_of(const MasterPlace& place, std::span<const Mat3> free);

/// Projector onto the null space of a sum of projectors.
Mat3 held_by_all(const Mat3& freedom);

/// Whether this corner has a weight in its projection.
constexpr bool has_share(double weight) {
  constexpr double share = 1e-6;  // above the rounding of coordinates in single precision
  return weight > share;
}

/// A vector of the slave node minus that of its projection.
Vec3 offset_from_below(const MasterPlace& place, const Vec3& of_slave, std::span<const Vec3> of_nodes);

/// Residuals r_A = c_A / covered_A [length].
void tie_residuals(const TieStart& start, const MortarSurfaces& surfaces, const MortarTopology& topology,
                   std::span<const Vec3> x, std::vector<Vec3>& residuals);

/// The levers - sum_f h_Af D_fK of each row, with the change D of the normal (normal_change.hpp) from x_before to x, or
/// its derivative at x without x_before [length^2]. So dc_A/dx_K is w_AK 1 plus the lever at x. Rows are empty without
/// a gap.
void tie_levers(const TieStart& start, const MortarSurfaces& surfaces, const MortarTopology& topology,
                std::span<const Vec3> x_before, std::span<const Vec3> x, NodeBlocks<Mat3>& levers);

/// Derivatives of the forces sum_A (w_AK 1 + lever_AK)^T T_A on each node K by x, at fixed multipliers T of the three
/// residuals, the traction on the slave [force/length^2]: one patch for each slave facet (`ours`) with a gap. x_before:
/// as of the levers. tractions: of the rows, followed by those of MortarSurfaces::rows_elsewhere.
void tie_patches(const TieStart& start, const MortarSurfaces& surfaces, const MortarTopology& topology,
                 std::span<const Vec3> x_before, std::span<const Vec3> x, std::span<const Vec3> tractions,
                 Patches& patches);

}  // namespace brunt::contact
