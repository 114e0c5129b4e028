// SPDX-License-Identifier: Apache-2.0
// What lies around a surface node and around the convex edges of the surface, taken once from the reference mesh.
#pragma once
#include <span>
#include <vector>

#include "brunt/comm/communicator.hpp"
#include "brunt/contact/surface/surface.hpp"
#include "brunt/mesh/local_mesh.hpp"
#include "brunt/surface/exposed.hpp"

namespace brunt::contact {

/// A row for each surface node: the nodes of all elements that contain it, ascending, where this rank owns it; else
/// empty. A node never meets a face of its own body whose element has one of these: such elements touch each other, so
/// that on a smooth surface nothing is near anything. Collective.
/// alive: of the elements; a removed one connects nothing.
Ragged<GlobalIndex> element_neighbours(const comm::Communicator& ranks, const mesh::LocalMesh& mesh,
                                       const Surface& surface, surface::Alive alive = {});

/// By how much the normals of two faces differ where they meet in an edge [radians].
struct EdgeAngles {
  double least = 0;  ///< at less there is none; < 0: a dent
  double blunt = 0;  ///< from here on it is a blunt one
  double sharp = 0;  ///< and from here on a sharp one
};

/// Edges between exactly two contact faces, by their reference normals, on the rank of the face with the lower
/// key, in ascending (gid, gid). Collective.
std::vector<SurfaceEdge> edges_of(const comm::Communicator& ranks, const mesh::LocalMesh& mesh, const Surface& surface,
                                  const EdgeAngles& angles);

/// Gives all copies of a surface node the flag that its owner has. Collective.
void report_to_copies(const comm::Communicator& ranks, const Surface& surface, std::vector<char>& flags);

/// A flag for each surface node: does it stand on a sharp one of the edges, whichever rank has it? Collective.
std::vector<char> nodes_on_rims(const comm::Communicator& ranks, const Surface& surface);

}  // namespace brunt::contact
