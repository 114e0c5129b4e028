// SPDX-License-Identifier: Apache-2.0
// Where bodies stand to each other before anything moves: the smallest gap, and nodes that are inside another body.
// Pure geometry on the whole mesh, so it sees overlaps of any depth (contact itself looks no deeper than its capture).
#pragma once
#include <string>
#include <vector>

#include "brunt/mesh/mesh.hpp"
#include "brunt/scene/input.hpp"

namespace brunt::app {

struct InitialOverlap {
  GlobalIndex node = 0;         ///< the input's number
  std::size_t part = 0;         ///< of the node, into Input::parts
  std::size_t other = 0;        ///< the part that it is inside
  double depth = 0;             ///< distance to the other's surface [length]; 0: not measured, of more than 1000 nodes
  bool only_a_warning = false;  ///< as the scene has it for this pair
};

struct InitialGaps {
  double smallest =
      -1;  ///< distance of a node to a face of a part that it may touch [length]; -1: none within one edge
  std::size_t part = 0, other = 0;       ///< of that node and face
  std::vector<InitialOverlap> overlaps;  ///< deepest first
};

/// Nodes deeper inside than 1e-4 of the longest edge of the nearest face overlap; shallower ones touch. Parts that
/// share nodes are one body.
InitialGaps initial_gaps(const scene::Input& input, const mesh::Mesh& mesh);

/// One line for each pair of parts that overlap: how many nodes, and the deepest. The pair with the deepest comes
/// first.
std::vector<std::string> overlap_lines(const scene::Input& input, const InitialGaps& gaps);

/// Every overlapping node on a line of its own, deepest first.
std::vector<std::string> overlap_list(const scene::Input& input, const InitialGaps& gaps);

/// Throws InputError with the overlaps that the scene does not allow; the others become warnings.
void judge_overlaps(const scene::Input& input, const InitialGaps& gaps, std::vector<std::string>& warnings);

}  // namespace brunt::app
