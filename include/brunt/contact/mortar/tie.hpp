// SPDX-License-Identifier: Apache-2.0
// Tied surfaces: the vector gap of each row, with the weights of the start, keeps its value of the start. That value
// turns with the slave's nodal normal, so that a gap across the surfaces at the start does not resist a rotation.
#pragma once
#include <array>
#include <span>
#include <vector>

#include "brunt/contact/mortar/interface.hpp"

namespace brunt::contact {

/// The master's place under a slave node at the start.
struct MasterPlace {
  FacetNodes nodes{no_index, no_index, no_index, no_index};  ///< the first no_index: there is none
  std::array<double, 4> weights{};                           ///< of the nodes, sum 1
};

struct TieStart {
  NodeBlocks<double> weights;      ///< w_AK in the tied state [length^2]
  std::vector<Vec3> normals;       ///< unit
  std::vector<Vec3> gap_vectors;   ///< G_A [length^3]
  std::vector<double> covered;     ///< 0: nothing is tied [length^2]
  std::vector<MasterPlace> below;  ///< of each row's node; empty until find_places_below
};

TieStart tie(const MortarRows& rows);

/// Fills TieStart::below. candidates, x: of the start.
void find_places_below(const MortarSurfaces& surfaces, const MortarTopology& topology,
                       const Ragged<LocalIndex>& candidates, std::span<const Vec3> x, TieStart& start);

/// Of each row: projector on the directions that its multipliers hold. Where supports or walls hold the slave node
/// along a direction, and also the place of the master under it (all nodes with a share in it), a multiplier would be
/// redundant, as at nodes of a plane of symmetry. A master that is free there is tied to the slave node's prescribed
/// motion. Zero for rows that are not tied. free: projector on the free directions of each node.
std::vector<Mat3> tied_directions(const MortarSurfaces& surfaces, const TieStart& start, std::span<const Mat3> free);

/// Sum of the projectors on the free directions of the nodes that have a share in a place; all directions where there
/// is none.
Mat3 freedom_of(const MasterPlace& place, std::span<const Mat3> free);

/// Projector on the directions along which a sum of projectors has nothing.
Mat3 held_by_all(const Mat3& freedom);

/// Has this corner a share in its place?
constexpr bool has_share(double weight) {
  constexpr double share = 1e-6;  // coordinates in single precision
  return weight > share;
}

/// A vector of the slave node less that of the place under it.
Vec3 offset_from_below(const MasterPlace& place, const Vec3& of_slave, std::span<const Vec3> of_nodes);

/// Residuals r_A = sum_K w_AK x_K / covered_A - (gap of the start, turned from the normal of the start to the one now)
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
