// SPDX-License-Identifier: Apache-2.0
// initial_overlap: move - overlapping nodes go out of the other body before anything else sees the mesh.
#pragma once
#include <string>
#include <vector>

#include "brunt/mesh/canonical.hpp"
#include "brunt/scene/input.hpp"
#include "initial_gaps.hpp"

namespace brunt::app {

struct MoveReport {
  std::size_t nodes = 0;
  double largest = 0;               ///< move [length]
  std::vector<std::string> faults;  ///< why it cannot be done; the mesh is then as it was
};

/// Moves surface nodes of the slave side, as contact chooses it, along the normals of the faces that they are behind
/// until nothing that the scene wants moved overlaps by more than `touching`: its own nodes onto the faces, and the
/// corners of faces that nodes of the master are behind. Some passes, each from the gaps that the last has left. The
/// coordinates are reference positions, so nothing is stressed. Refused where a node would move along a direction that
/// the scene holds (fixed, symmetry, prescribed), where a corner of an element would keep less than a fifth of its
/// volume, and where passes come to no end. whole: with the selections of the scene. gaps: of the mesh as it is; none
/// of those to be moved too deep.
MoveReport move_overlaps(const scene::Input& input, mesh::CanonicalMesh& whole, const InitialGaps& gaps);

}  // namespace brunt::app
