// SPDX-License-Identifier: Apache-2.0
// initial_overlap: move - overlapping nodes go out of the other body before anything else sees the mesh.
#pragma once
#include <optional>
#include <span>
#include <vector>

#include "brunt/setup/initial_gaps.hpp"

namespace brunt::setup {

constexpr int most_moving_passes = 20;

/// Nodes that something holds in a direction.
struct HeldNodes {
  std::span<const LocalIndex> nodes;
  Vec3 direction;  ///< unit
};

/// Held nodes that would move in the direction in which they are held.
struct HeldMove {
  std::size_t held = 0;  ///< into the list of held nodes
  std::size_t count = 0;
  LocalIndex first = no_index;
  double distance = 0;  ///< that the first would move by [length]
};

/// The element that would lose most of its volume at a corner.
struct SpoiledElement {
  std::size_t block = 0;
  LocalIndex element = 0;
  double kept = 0;    ///< share of the volume; <= 0: turned inside out
  double wanted = 0;  ///< the least that it must keep
};

struct OverlapMoves {
  std::size_t nodes = 0;
  double largest = 0;  ///< move [length]
  // why it cannot be done:
  std::vector<HeldMove> held;
  std::optional<SpoiledElement> spoiled;
  std::vector<InitialOverlap> left;  ///< what overlaps after the last pass, deepest first
  [[nodiscard]] bool refused() const { return !held.empty() || spoiled || !left.empty(); }
};

/// Moves surface nodes of the slave side, as contact chooses it, along the normals of the faces that they are behind
/// until nothing that the scene wants moved overlaps by more than `touching`: its own nodes onto the faces, and the
/// corners of faces that nodes of the master are behind. Some passes, each from the gaps that the last has left. The
/// coordinates are reference positions, so nothing is stressed. Refused where a node would move along a direction that
/// the scene holds (fixed, symmetry, prescribed), where a corner of an element would keep less than
/// Tolerances::kept_volume, and where passes come to no end; the mesh is then as it was. gaps: of the mesh as it is;
/// none of those to be moved too deep.
OverlapMoves move_overlaps(mesh::Mesh& mesh, const StartRules& rules, std::span<const HeldNodes> held,
                           const InitialGaps& gaps);

}  // namespace brunt::setup
