// SPDX-License-Identifier: Apache-2.0
// Rotations of nodes of shells for probes of a node, of a set and of a deformable part. Collective.
#pragma once
#include <cstddef>

#include "app/state/prepared.hpp"

namespace brunt::app {

/// Whether the probe asks for rotations of nodes: not of a rigid part or a joint.
bool is_rotation_of_nodes(const Prepared& run, std::size_t probe);

/// Means over the nodes of the probe that turn, each with its rotary inertia as weight: `rotation` from t = 0 to t_n as
/// a rotation vector (axis times angle, of length at most pi), `angular_velocity` at the half step before.
Vec3 mean_rotation(const Prepared& run, std::size_t probe);

/// Sum of the angular impulses of supports of rotations on the nodes of the probe, about each node [moment time].
Vec3 rotation_reaction(const Prepared& run, std::size_t probe);

}  // namespace brunt::app
