// SPDX-License-Identifier: Apache-2.0
// The surface of the whole model: each rank has its part, and owners know all faces around their nodes.
#pragma once
#include <span>

#include "comm/communicator.hpp"
#include "contact/surface/surface.hpp"
#include "mesh/local_mesh.hpp"
#include "surface/exposed.hpp"

namespace brunt::contact {

/// excluded: one flag for each of mesh.faces; such faces (in a symmetry plane) have no contact, but their nodes may
/// touch walls. inverse_mass: of the mesh's nodes. Quantities of bodies refer to the reference state. Collective.
Surface join_surface(const comm::Communicator& ranks, const mesh::LocalMesh& mesh, std::span<const char> excluded,
                     std::span<const double> inverse_mass, const Tolerances& tolerances = standard_tolerances);

/// The remaining bodies after a removal of elements.
struct Remains {
  surface::ExposedSurface outside;
  std::vector<char> excluded;  ///< a flag a face, as above
  surface::Alive alive;
};

/// The surface of the remaining bodies: faces keep their keys, nodes without an element are slaves without faces. The
/// quantities of bodies, mean_edge and mean_element_depth are those of this surface; see update_surface. Collective.
Surface join_surface(const comm::Communicator& ranks, const mesh::LocalMesh& mesh, const Remains& remains,
                     std::span<const double> inverse_mass, const Tolerances& tolerances = standard_tolerances);

}  // namespace brunt::contact
