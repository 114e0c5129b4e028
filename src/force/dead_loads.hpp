// SPDX-License-Identifier: Apache-2.0
// Dead loads: forces of constant direction that do not follow the motion.
#pragma once
#include "model/model.hpp"

namespace brunt::force {

/// Initial area of a face: exact for flat faces, half the cross product of the diagonals for warped ones.
double reference_area(const model::Model& model, const mesh::ExteriorFace& face);

/// Adds the forces of all dead loads at t_n to scratch.load: weight times value times curve, load by load; their
/// moments to scratch.moment_load.
void add_dead_loads(const model::Model& model, double time, model::Scratch& scratch);

}  // namespace brunt::force
