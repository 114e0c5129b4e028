// SPDX-License-Identifier: Apache-2.0
// Where bodies stand to each other before anything moves: the smallest gap, nodes that are inside another body or
// another part of their own, edges that pass through one, and bodies in one place. Pure geometry on the whole mesh, so
// it sees overlaps of any depth (contact itself looks no deeper than its capture).
#pragma once
#include <array>
#include <vector>

#include "brunt/mesh/mesh.hpp"
#include "brunt/setup/solids.hpp"
#include "brunt/setup/start_rules.hpp"

namespace brunt::setup {

struct InitialOverlap {
  LocalIndex node = 0;                     ///< of the mesh
  std::size_t block = 0, other_block = 0;  ///< of the node, and that it is inside
  std::int32_t body = 0, other_body = 0;
  double penetration = 0;  ///< behind the face [length]; 0: not measured, of more than 1000 deep nodes of a pair
  FaceNodes face{no_index, no_index, no_index, no_index};  ///< that the node is behind; none: not measured
  /// A slave deeper than contact looks behind a face: it would be let go, or seen from the wrong side.
  bool too_deep = false;
  OverlapRule rule = OverlapRule::error;  ///< as the scene has it for this pair
  [[nodiscard]] bool is_within_itself() const { return body == other_body; }
  [[nodiscard]] bool is_moved() const { return rule == OverlapRule::move; }
};

/// Edges of one block that pass through another without an end or a corner inside: nodes on the right sides of all
/// faces, which contact would see as they should be.
struct Piercing {
  std::size_t block = 0, other_block = 0;  ///< of the edges, of the faces
  std::size_t edges = 0;
  std::array<LocalIndex, 2> edge{};  ///< the first
  FaceNodes face{};                  ///< that it passes through
  OverlapRule rule = OverlapRule::error;
};

/// Elements of one block in the space of another, all of whose surface nodes touch: contact would see nothing.
struct SharedSpace {
  std::size_t block = 0, other_block = 0;  ///< of the elements, and where they are
  std::size_t elements = 0;
  GlobalIndex first = 0;  ///< the input's number of the first
  OverlapRule rule = OverlapRule::error;
};

struct InitialGaps {
  double smallest =
      -1;  ///< distance of a node to a face of a part that it may touch [length]; -1: none within one edge
  std::size_t block = 0, other_block = 0;  ///< of that node and face
  std::vector<InitialOverlap> overlaps;    ///< deepest first
  std::vector<Piercing> piercings;
  std::vector<SharedSpace> shared;
};

/// Nodes deeper inside than `touching` overlap; shallower ones touch. Parts that share nodes are one body: of a body
/// with itself only overlaps are reported, in elements that do not touch those of the node; neither gaps (the thickness
/// of every part would be one) nor edges that pass through it.
InitialGaps initial_gaps(const mesh::Mesh& mesh, const StartRules& rules);

}  // namespace brunt::setup
