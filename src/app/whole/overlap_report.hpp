// SPDX-License-Identifier: Apache-2.0
// Messages about initial overlaps.
#pragma once
#include <string>
#include <vector>

#include "scene/input.hpp"
#include "setup/initial_gaps.hpp"

namespace brunt::app {

/// Names of nodes, faces and parts are the input's.
struct OverlapReport {
  std::vector<std::string>
      list;  ///< every overlapping node on a line of its own, deepest first, and every piercing and shared space
  std::vector<std::string> deepest;  ///< of these the ten deepest of each pair of parts, and the number of further ones
  std::vector<std::string> warnings;  ///< overlaps that the scene accepts
  std::vector<std::string>
      faults;  ///< overlaps that it does not accept, or that cannot be treated as requested; then advice
  std::vector<std::string> notes;  ///< treatment that was applied
};

/// One line for each pair of overlapping parts: the number of nodes, and the deepest one. The pair with the deepest one
/// comes first, then the parts that intersect others. Overlaps under `move` and `offset` are reported only if they
/// cannot be treated (deeper than contact detects, or intersecting edges); those under `place` only for a body with
/// itself.
OverlapReport report_overlaps(const scene::Input& input, const mesh::Mesh& mesh, const setup::InitialGaps& gaps);

/// Identification of a node or face in the input.
std::string name_of_face(const mesh::Mesh& mesh, const setup::FaceNodes& face);

}  // namespace brunt::app
