// SPDX-License-Identifier: Apache-2.0
// Contact of a prepared run: from the model's specification to contact, and its sums to and from checkpoints.
#pragma once
#include <vector>

#include "prepared.hpp"
#include "time/step.hpp"

namespace brunt::app {

/// Speed of dilatational waves in the initial material of the block [velocity].
double speed_of_sound(const model::ElementBlock& block);

/// Material properties of blocks for contact.
contact::BlockProperties block_properties(const model::Model& model);

/// Properties of rigid parts for contact.
contact::RigidBodies rigid_bodies(const model::Model& model);
/// Of the local nodes [1/mass].
std::vector<double> inverse_masses(const model::State& state);

/// Creates Prepared::contact if the scene has contact or walls. Collective.
void make_contact(Prepared& run);

/// Whether the frequency of the assembled mesh may bound the step: implicit scenes have no stable step.
bool bounded_by_mesh(const scene::Input& input);

/// Control of the step: the scene's cfl, less if contact adds springs.
time::StepControl step_control(Prepared& run);

/// The exact sums of all ranks as doubles (each a 32-bit limb with carries): independent of the number of ranks.
/// Collective.
std::vector<double> save_sums(const comm::Communicator& ranks, contact::Contact& contact);
/// The root restores them, the other ranks start from zero.
void restore_sums(const comm::Communicator& ranks, const std::vector<double>& saved, contact::Contact& contact);

}  // namespace brunt::app
