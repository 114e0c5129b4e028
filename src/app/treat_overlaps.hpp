// SPDX-License-Identifier: Apache-2.0
// Overlaps at the start, as the scene wants them treated.
#pragma once
#include <vector>

#include "brunt/contact/detection/detection.hpp"
#include "brunt/mesh/canonical.hpp"
#include "brunt/scene/input.hpp"
#include "brunt/setup/initial_gaps.hpp"
#include "overlap_report.hpp"

namespace brunt::app {

struct TreatedOverlaps {
  setup::InitialGaps gaps;  ///< of the mesh after parts were placed and nodes moved
  OverlapReport report;
  std::vector<contact::AcceptedOverlap> accepted;  ///< what `offset` keeps, as contact wants it
  bool recovered = false;  ///< some are left to contact (`warn`), which gives the bodies energy in parting them
};

/// Places parts and moves nodes of the mesh where the scene says so. What the scene does not allow, or cannot have as
/// it asks, is told in the report's faults; nothing is moved then. A function of the scene and the mesh, so a restart
/// has the same.
TreatedOverlaps treat_overlaps(const scene::Input& input, mesh::CanonicalMesh& whole);

}  // namespace brunt::app
