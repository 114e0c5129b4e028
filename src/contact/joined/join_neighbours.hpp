// SPDX-License-Identifier: Apache-2.0
// The neighbourhood of surface nodes and of the convex edges of the surface, computed once from the reference mesh.
#pragma once
#include <span>
#include <vector>

#include "comm/communicator.hpp"
#include "contact/surface/surface.hpp"
#include "mesh/local_mesh.hpp"
#include "surface/exposed.hpp"

namespace brunt::contact {

/// A row for each surface node: the nodes of all elements that contain it, ascending, if this rank owns it; otherwise
/// empty. A node never has contact with a face of its own body whose element contains one of these nodes. Such elements
/// touch each other, so on a smooth surface no candidates arise. alive: of the elements; a removed one connects
/// nothing. Collective.
Ragged<GlobalIndex> element_neighbours(const comm::Communicator& ranks, const mesh::LocalMesh& mesh,
                                       const Surface& surface, surface::Alive alive = {});

/// Classes of the angle between the normals of two faces at their common edge [radians].
struct EdgeAngles {
  double least = 0;  ///< smaller angles are not edges; < 0: concave
  double blunt = 0;  ///< from this angle on the edge is blunt
  double sharp = 0;  ///< from this angle on it is sharp
};

/// Edges between exactly two contact faces, from their reference normals, on the rank of the face with the lower key,
/// in ascending (gid, gid). Collective.
std::vector<SurfaceEdge> edges_of(const comm::Communicator& ranks, const mesh::LocalMesh& mesh, const Surface& surface,
                                  const EdgeAngles& angles);

/// Copies the flag of its owner to all copies of a surface node. Collective.
void report_to_copies(const comm::Communicator& ranks, const Surface& surface, std::vector<char>& flags);

/// A flag for each surface node: whether it lies on a sharp edge, on whichever rank. Collective.
std::vector<char> nodes_on_rims(const comm::Communicator& ranks, const Surface& surface);

}  // namespace brunt::contact
