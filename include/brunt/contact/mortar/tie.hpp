// SPDX-License-Identifier: Apache-2.0
// Tied surfaces: the vector gap of each row, with the weights of the initial configuration, keeps its initial value.
// That value rotates with the slave's nodal normal, so that an initial gap between the surfaces does not resist a
// rotation.
#pragma once
#include <array>
#include <span>
#include <vector>

#include "brunt/contact/mortar/interface.hpp"

namespace brunt::contact {

/// The projection of a slave node onto the master in the initial configuration.
struct MasterPlace {
  FacetNodes nodes{no_index, no_index, no_index, no_index};  ///< the first is no_index if there is no projection
  std::array<double, 4> weights{};                           ///< of the nodes, sum 1
};

struct TieStart {
  NodeBlocks<double> weights;      ///< w_AK in the tied state [length^2]
  std::vector<Vec3> normals;       ///< unit
  std::vector<Vec3> gap_vectors;   ///< G_A [length^3]
  std::vector<double> covered;     ///< 0: the row is not tied [length^2]
  std::vector<MasterPlace> below;  ///< of each row's node; empty until find_places_below
};

TieStart tie(const MortarRows& rows);

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

/// Residuals r_A = sum_K w_AK x_K / covered_A - (initial gap, rotated from the initial normal to the current one)
/// [length]. normals: of nodal_normals at x.
void tie_residuals(const TieStart& start, std::span<const Vec3> x, std::span<const Vec3> normals,
                   std::vector<Vec3>& residuals);

/// dr_A/dx_K. normal_slopes: of nodal_normals at x.
void tie_gradient(const TieStart& start, std::span<const Vec3> normals, const NodeBlocks<Mat3>& normal_slopes,
                  NodeBlocks<Mat3>& gradient);

/// forces[K] += w_AK T_A; T: multipliers of the three residuals, the traction on the slave [force/length^2]. Linear in
/// T, and independent of x.
void add_tie_forces(const TieStart& start, std::span<const Vec3> tractions, std::span<Vec3> forces);

}  // namespace brunt::contact
