// SPDX-License-Identifier: Apache-2.0
// What the user is told of overlaps at the start.
#pragma once
#include <string>
#include <vector>

#include "brunt/scene/input.hpp"
#include "brunt/setup/initial_gaps.hpp"

namespace brunt::app {

/// Names of nodes, faces and parts are the input's.
struct OverlapReport {
  std::vector<std::string>
      list;  ///< every overlapping node on a line of its own, deepest first, and every piercing and shared space
  std::vector<std::string> deepest;   ///< of these the ten deepest of each pair of parts, and how many more there are
  std::vector<std::string> warnings;  ///< what the scene accepts
  std::vector<std::string> faults;    ///< what it does not, and what cannot be treated as it asks; then advice
  std::vector<std::string> notes;     ///< what was done
};

/// One line for each pair of parts that overlap: how many nodes, and the deepest. The pair with the deepest comes
/// first. Then the parts that pierce others. Overlaps under `move` and `offset` are told only where that cannot be
/// done: deeper than contact looks, or pierced; those under `place` only of a body with itself.
OverlapReport report_overlaps(const scene::Input& input, const mesh::Mesh& mesh, const setup::InitialGaps& gaps);

/// A node or face as the user knows it.
std::string name_of_face(const mesh::Mesh& mesh, const setup::FaceNodes& face);

}  // namespace brunt::app
