// SPDX-License-Identifier: Apache-2.0
// Treatment of initial overlaps as requested by the scene.
#pragma once
#include <vector>

#include "contact/detection/detection.hpp"
#include "mesh/canonical.hpp"
#include "overlap_report.hpp"
#include "scene/input.hpp"
#include "setup/initial_gaps.hpp"

namespace brunt::app {

struct TreatedOverlaps {
  setup::InitialGaps gaps;  ///< of the mesh after parts were placed and nodes moved
  OverlapReport report;
  std::vector<contact::AcceptedOverlap> accepted;  ///< overlaps kept by `offset`, in the form for contact
  bool recovered = false;  ///< some are left to contact (`warn`), which supplies energy when it separates the bodies
};

/// Places parts and moves nodes of the mesh as requested by the scene. Inadmissible overlaps, and requests that cannot
/// be satisfied, become faults of the report, and nothing is moved. A function of the scene and the mesh, so a restart
/// has the same result.
TreatedOverlaps treat_overlaps(const scene::Input& input, mesh::CanonicalMesh& whole);

}  // namespace brunt::app
