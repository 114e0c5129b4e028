// SPDX-License-Identifier: Apache-2.0
// initial_overlap: move - overlapping nodes are moved out of the other body at the start of the set-up.
#pragma once
#include <optional>
#include <span>
#include <vector>

#include "setup/initial_gaps.hpp"

namespace brunt::setup {

constexpr int most_moving_passes = 20;

/// Nodes that are constrained in a direction.
struct HeldNodes {
  std::span<const LocalIndex> nodes;
  Vec3 direction;  ///< unit
};

/// Constrained nodes that would move in their constrained direction.
struct HeldMove {
  std::size_t held = 0;  ///< into the list of held nodes
  std::size_t count = 0;
  LocalIndex first = no_index;
  double distance = 0;  ///< by which the first one would move [length]
};

/// The element that would lose the largest share of its volume at a corner.
struct SpoiledElement {
  std::size_t block = 0;
  LocalIndex element = 0;
  double kept = 0;    ///< share of the volume; <= 0: inverted
  double wanted = 0;  ///< the smallest admissible share
};

struct OverlapMoves {
  std::size_t nodes = 0;
  double largest = 0;  ///< move [length]
  // Reasons for failure:
  std::vector<HeldMove> held;
  std::optional<SpoiledElement> spoiled;
  std::vector<InitialOverlap> left;  ///< remaining overlaps after the last pass, deepest first
  [[nodiscard]] bool refused() const { return !held.empty() || spoiled || !left.empty(); }
};

/// Moves surface nodes of the slave side, as contact chooses it, along the normals of the faces in front of them, until
/// no overlap that is to be moved exceeds `touching`. Slave nodes are moved onto the faces, and corners of slave faces
/// in front of master nodes are moved as well. Each of several passes starts from the gaps that the previous one left.
/// The coordinates are reference positions, so no stress arises. It fails if a node would move along a direction that
/// the scene constrains (fixed, symmetry, prescribed), if a corner of an element would keep less than
/// Tolerances::kept_volume, or if the passes do not converge; the mesh is then unchanged. gaps: of the mesh as it is;
/// none of those to be moved is too deep.
OverlapMoves move_overlaps(mesh::Mesh& mesh, const StartRules& rules, std::span<const HeldNodes> held,
                           const InitialGaps& gaps);

}  // namespace brunt::setup
