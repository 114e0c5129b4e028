// SPDX-License-Identifier: Apache-2.0
// Contact of a prepared run: from the model's specification to the contact room, and its sums to and from checkpoints.
#pragma once
#include <vector>

#include "brunt/time/step.hpp"
#include "prepare.hpp"

namespace brunt::app {

/// Of dilatational waves in the block's material as it is at the start [velocity].
double speed_of_sound(const model::ElementBlock& block);

/// What contact is told of the materials of blocks.
contact::BlockProperties block_properties(const model::Model& model);

/// What it is told of rigid parts.
contact::RigidBodies rigid_bodies(const model::Model& model);
/// Of the local nodes [1/mass].
std::vector<double> inverse_masses(const model::State& state);
/// Nodes that supports hold, with what is left of their freedom.
std::vector<contact::ConstrainedNode> held_nodes(const model::Model& model);

/// Makes Prepared::contact where the scene has contact or walls. Collective.
void make_contact(Prepared& run);

/// How the step follows what is stable: the scene's cfl, less where contact adds springs.
time::StepControl step_control(Prepared& run);

/// The exact sums of all ranks as doubles (each a 32-bit limb with carries): the same whatever the number of ranks.
/// Collective.
std::vector<double> save_sums(const comm::Communicator& ranks, contact::Contact& contact);
/// The root takes them over, the other ranks start from zero.
void restore_sums(const comm::Communicator& ranks, const std::vector<double>& saved, contact::Contact& contact);

}  // namespace brunt::app
