// SPDX-License-Identifier: Apache-2.0
// Lumped mass: every corner takes an equal share of the mass of its element.
#pragma once
#include "model/model.hpp"

namespace brunt::force {

enum class Lumped { all, deformable };  ///< elements whose masses go to their nodes

/// Writes the mass of each element to its history, and the sum of corner shares to the first component of scratch.force
/// (border nodes: separate values in scratch.slots). Throws GuardError for an element without volume.
void lump_mass(const model::Model& model, model::State& state, model::Scratch& scratch, Lumped elements = Lumped::all);

/// Likewise the rotary inertia of shells, to their histories and the first component of scratch.moment (and
/// scratch.moment_slots). Masses are in the histories already.
void lump_rotary_inertia(const model::Model& model, model::State& state, model::Scratch& scratch);

/// Volume of one hexahedron (exact for trilinear faces), tetrahedron or shell with reference corners X.
double element_volume(const model::ElementBlock& block, const Quad* reference, LocalIndex element);

}  // namespace brunt::force
