// SPDX-License-Identifier: Apache-2.0
// Probes of rotations need nodes that turn; which nodes do is known with their inertia.
#pragma once
#include "app/state/prepared.hpp"

namespace brunt::app {

/// Throws InputError for a probe of rotations of a deformable part, a set or a node, none of whose nodes belongs to a
/// shell. Collective.
void check_rotation_probes(const Prepared& run);

}  // namespace brunt::app
