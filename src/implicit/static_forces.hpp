// SPDX-License-Identifier: Apache-2.0
// Forces of the static state at t_n. Impulses divided by the time since the last row would be means over the steps.
#pragma once
#include "implicit/solver.hpp"

namespace brunt::implicit {

[[nodiscard]] bool is_static(const Solver& solver);

/// Force of the supports on a node of this rank [force].
Vec3 support_force(const model::Model& model, const Solver& solver, std::size_t node);

/// Everything that acts on a rigid body except its supports; moments about its centre. The same on all ranks.
/// Collective.
model::Wrench force_on_body(const Scene& scene, const Solver& solver, std::size_t body);

/// Of the supports, which balance these forces along the directions that they hold.
model::Wrench support_of_body(const model::RigidBody& body, const model::Wrench& acting);

}  // namespace brunt::implicit
