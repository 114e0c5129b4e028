// SPDX-License-Identifier: Apache-2.0
// Prediction of the exterior faces that will cause work in contact, from the positions and velocities at the start. It
// affects the balance between ranks only, not the results.
#pragma once
#include <span>
#include <vector>

#include "contact/surface/surface.hpp"
#include "mesh/mesh.hpp"

namespace brunt::setup {

/// Data that are known before the run.
struct Outlook {
  std::span<const double> density;  ///< of each block [mass/length^3]
  std::span<const Vec3> velocity;   ///< of each node at the start [length/time]
  double duration = 0;              ///< of the run [time]; may be infinite
};

/// The faces of slaves (chosen as by is_slave; detection and enforcement run on the ranks of slaves) that are near the
/// bounding box of possible contact partners, within the size of a face, or move towards it. With two passes both sides
/// count, except nodes of the second pass that will coincide with nodes of the first, which have no constraints there.
/// If nothing is near anything, all faces are returned; if no pair may touch, none. faces: the contact faces of the
/// whole mesh.
std::vector<mesh::Side> likely_slaves(const mesh::Mesh& mesh, std::span<const mesh::Side> faces,
                                      const contact::Specification& specification, const Outlook& outlook);

/// The quantities that determine the slave (as in is_slave), for each body of the whole mesh. density: of each block.
std::vector<contact::BodyFigures> body_figures(const mesh::Mesh& mesh, std::span<const mesh::Side> faces,
                                               std::span<const double> density);

}  // namespace brunt::setup
