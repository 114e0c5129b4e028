// SPDX-License-Identifier: Apache-2.0
// Seams: where bodies are flush in the reference configuration, the face of one continues in the face of the other, and
// the edge between them is not an edge of the combined surface. Under load one of them yields slightly, and the other
// protrudes by this amount. A sliding node then meets the side of the protruding body below its edge, and would be
// stopped by a step that does not exist in the model.
#pragma once
#include "comm/communicator.hpp"
#include "contact/surface/surface.hpp"
#include "mesh/local_mesh.hpp"

namespace brunt::contact {

/// Sets `seams` of faces, `seam` and `end_at_side` of edges, `seam_sag` of nodes and `flush`, from the reference mesh.
/// A side of a face is a seam if a point slightly beyond it in the plane of the face, at a quarter or at three quarters
/// of the side, lies on another face with a similar normal and without common nodes (contact/data/tolerances.hpp:
/// seam). Collective.
void find_seams(const comm::Communicator& ranks, const mesh::LocalMesh& mesh, const Tolerances& tolerances,
                Surface& surface);

}  // namespace brunt::contact
