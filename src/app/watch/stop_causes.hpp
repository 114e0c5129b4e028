// SPDX-License-Identifier: Apache-2.0
// Causes for the user why a run cannot continue.
#pragma once
#include <string>

#include "app/state/prepared.hpp"
#include "element_place.hpp"

namespace brunt::app {

/// Cause of the decrease of this element's stable step.
const char* cause_of_collapse(const ElementPlace& place);

/// Possible cause of the loss of volume of an element of this block; empty: unknown.
const char* cause_of_lost_volume(const model::ElementBlock& block);

/// Of a negative internal energy: elements give more work than they took. Only causes that the model has are named.
/// folded: number of folded hex8 elements.
std::string cause_of_given_work(const model::Model& model, GlobalIndex folded);

/// What a scene has that may supply energy among rigid bodies.
struct RigidSources {
  bool contact = false, walls = false, drives = false, moving_walls = false;
  bool joints = false;    ///< or supports of a reference point
  bool at_limit = false;  ///< iterations of contact have ended at enforcement.max_iterations
};

/// Where the energy may come from in a scene without deformable elements. Only what the scene has is named.
std::string cause_among_rigid_bodies(const RigidSources& sources);

std::string not_at_rest(const model::Relaxation& phase, const scene::Relaxation& asked);

}  // namespace brunt::app
