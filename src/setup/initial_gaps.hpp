// SPDX-License-Identifier: Apache-2.0
// Initial gaps and overlaps of the bodies: the smallest gap, nodes inside another body or another part of their own
// body, edges that pass through a body, and coincident bodies. Pure geometry on the whole mesh, so overlaps of any
// depth are found (contact itself detects penetrations up to its capture distance).
#pragma once
#include <array>
#include <vector>

#include "mesh/mesh.hpp"
#include "setup/solids.hpp"
#include "setup/start_rules.hpp"

namespace brunt::setup {

struct InitialOverlap {
  LocalIndex node = 0;                     ///< of the mesh
  std::size_t block = 0, other_block = 0;  ///< of the node, and of the block that contains it
  std::int32_t body = 0, other_body = 0;
  double penetration = 0;  ///< behind the face [length]; 0: not measured (more than 1000 deep nodes in a pair)
  FaceNodes face{no_index, no_index, no_index, no_index};  ///< the face in front of the node; none: not measured
  /// The node is deeper behind a face than contact detects: it would be missed, or detected from the wrong side.
  bool too_deep = false;
  OverlapRule rule = OverlapRule::error;  ///< rule of the scene for this pair
  [[nodiscard]] bool is_within_itself() const { return body == other_body; }
  [[nodiscard]] bool is_moved() const { return rule == OverlapRule::move; }
};

/// Edges of one block that pass through another without an end or a corner inside: all nodes are on the correct sides
/// of all faces, so contact would not detect the overlap.
struct Piercing {
  std::size_t block = 0, other_block = 0;  ///< of the edges, of the faces
  std::size_t edges = 0;
  std::array<LocalIndex, 2> edge{};  ///< the first
  FaceNodes face{};                  ///< that it passes through
  OverlapRule rule = OverlapRule::error;
};

/// Elements of one block that coincide with another block whose surface nodes all touch: contact would detect nothing.
struct SharedSpace {
  std::size_t block = 0, other_block = 0;  ///< of the elements, and of the block that contains them
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

/// Nodes deeper inside than `touching` overlap; shallower ones touch. Parts that share nodes are one body. For a body
/// with itself only overlaps are reported, in elements that do not touch those of the node. Gaps within a body are not
/// reported (the thickness of every part would be one), nor are edges that pass through it.
InitialGaps initial_gaps(const mesh::Mesh& mesh, const StartRules& rules);

}  // namespace brunt::setup
