// SPDX-License-Identifier: Apache-2.0
// The surface of the whole model, each rank its part, with owners that know all faces around their nodes.
#pragma once
#include <span>

#include "brunt/comm/communicator.hpp"
#include "brunt/contact/surface/surface.hpp"
#include "brunt/mesh/local_mesh.hpp"
#include "brunt/surface/exposed.hpp"

namespace brunt::contact {

/// excluded: one flag for each of mesh.faces; such faces (in a symmetry plane) touch nothing, their nodes still meet
/// walls. inverse_mass: of the mesh's nodes. Figures of bodies are taken in the reference state. Collective.
Surface join_surface(const comm::Communicator& ranks, const mesh::LocalMesh& mesh, std::span<const char> excluded,
                     std::span<const double> inverse_mass, const Tolerances& tolerances = standard_tolerances);

/// What is left of the bodies once elements have been removed.
struct Remains {
  surface::ExposedSurface outside;
  std::vector<char> excluded;  ///< a flag a face, as above
  surface::Alive alive;
};

/// The surface of what is left: faces keep their keys, nodes without an element are slaves without faces. The figures
/// of bodies, mean_edge and mean_element_depth are those of this surface; see update_surface. Collective.
Surface join_surface(const comm::Communicator& ranks, const mesh::LocalMesh& mesh, const Remains& remains,
                     std::span<const double> inverse_mass, const Tolerances& tolerances = standard_tolerances);

}  // namespace brunt::contact
