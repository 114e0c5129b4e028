// SPDX-License-Identifier: Apache-2.0
// Probes of joints between rigid parts.
#pragma once
#include <string_view>

#include "app/state/prepared.hpp"

namespace brunt::app {

/// The joint of this name, in Model::joints.
std::size_t joint_of(const model::Model& model, std::string_view name);

/// `angle` [rad] or `gap`, the distance of the joint's two points [length], at t_n.
double joint_place(const Prepared& run, std::size_t joint, std::string_view field);

/// Impulse since t = 0 of `force` [momentum], or of `moment` about the joint's point [mass length^2/time], on its first
/// part.
Vec3 joint_impulse(const Prepared& run, std::size_t joint, std::string_view field);

}  // namespace brunt::app
