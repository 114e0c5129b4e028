// SPDX-License-Identifier: Apache-2.0
// Joints at the start: what the scene's initial velocities contradict, and what the program tells of redundant joints.
#pragma once
#include "app/state/prepared.hpp"

namespace brunt::app {

/// Adds notes to the report of the start. Throws InputError if initial velocities open joints.
void check_joints(Prepared& run);

}  // namespace brunt::app
