// SPDX-License-Identifier: Apache-2.0
// Seams: where bodies lie flush in the reference configuration, the face of one goes on in the face of the other, and
// the edge between them is no edge of what both form. Under load one of them sags by a little, and the other stands
// out by so much: what slides along comes to its side below the edge, and would be stopped dead by a step that no
// surface of the model has.
#pragma once
#include "brunt/comm/communicator.hpp"
#include "brunt/contact/surface/surface.hpp"
#include "brunt/mesh/local_mesh.hpp"

namespace brunt::contact {

/// Sets `seams` of faces, `seam` and `end_at_side` of edges, `seam_sag` of nodes and `flush`, from the reference mesh.
/// A side of a face is a seam where a point a little beyond it in the face's plane, at a quarter or at three quarters
/// of the side, lies on another face that looks the same way and has no node in common with it
/// (detection/tolerances.hpp: seam). Collective.
void find_seams(const comm::Communicator& ranks, const mesh::LocalMesh& mesh, const Tolerances& tolerances,
                Surface& surface);

}  // namespace brunt::contact
