// SPDX-License-Identifier: Apache-2.0
// Which exterior faces will bring contact its work, foretold from where the bodies stand and how they move at the
// start. Only the balance between ranks depends on it, no result does.
#pragma once
#include <span>
#include <vector>

#include "brunt/contact/surface/surface.hpp"
#include "brunt/mesh/mesh.hpp"

namespace brunt::setup {

/// What is known before the run.
struct Outlook {
  std::span<const double> density;  ///< of each block [mass/length^3]
  std::span<const Vec3> velocity;   ///< of each node at the start [length/time]
  double duration = 0;              ///< of the run [time]; may be infinite
};

/// The faces of slaves (as is_slave chooses them; detection and enforcement run on the ranks of slaves) that are near
/// the box around what they may meet, by a face's size, or that fly on towards it; of two passes both, but for nodes of
/// the second that will lie on nodes of the first, which have no rows there. Where nothing is near anything, all
/// faces; where no pair may meet, none. faces: the contact faces of the whole mesh.
std::vector<mesh::Side> likely_slaves(const mesh::Mesh& mesh, std::span<const mesh::Side> faces,
                                      const contact::Specification& specification, const Outlook& outlook);

/// What decides who is slave (as is_slave does), for each body of the whole mesh. density: of each block.
std::vector<contact::BodyFigures> body_figures(const mesh::Mesh& mesh, std::span<const mesh::Side> faces,
                                               std::span<const double> density);

}  // namespace brunt::setup
