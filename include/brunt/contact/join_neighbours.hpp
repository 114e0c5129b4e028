// SPDX-License-Identifier: Apache-2.0
// What lies around a surface node and around the sharp edges of the surface, taken once from the reference mesh.
#pragma once
#include <span>
#include <vector>

#include "brunt/comm/communicator.hpp"
#include "brunt/contact/surface/surface.hpp"
#include "brunt/mesh/local_mesh.hpp"

namespace brunt::contact {

/// A row for each surface node: the nodes of all elements that contain it, ascending, where this rank owns it; else
/// empty. A node never meets a face of its own body whose element has one of these: such elements touch each other, so
/// that on a smooth surface nothing is near anything. Collective.
Ragged<GlobalIndex> element_neighbours(const comm::Communicator& ranks, const mesh::LocalMesh& mesh,
                                       const Surface& surface);

/// Convex edges between exactly two contact faces whose reference normals differ by more than `least_angle` [radians],
/// on the rank of the face with the lower key, in ascending (gid, gid). Collective.
std::vector<SurfaceEdge> sharp_edges(const comm::Communicator& ranks, const mesh::LocalMesh& mesh,
                                     const Surface& surface, double least_angle);

/// A flag for each surface node that this rank owns (0 for others): does it stand on one of the sharp edges, whichever
/// rank has it? Collective.
std::vector<char> nodes_on_edges(const comm::Communicator& ranks, const Surface& surface);

}  // namespace brunt::contact
