// SPDX-License-Identifier: Apache-2.0
// State and Scratch of a model at t = 0: everything that a step needs is sized here, once.
#pragma once
#include <span>

#include "model/model.hpp"
#include "model/registry.hpp"
#include "time/links.hpp"

namespace brunt::time {

/// Determines the history variables of each element, sizes all arrays, lumps the mass. Collective. `links` must belong
/// to the model. `rate`: initial rates of rotation of nodes of shells, by node; none: zero.
void initialise(model::Model& model, model::State& state, model::Scratch& scratch, Links& links,
                std::span<const Vec3> velocity, std::span<const Vec3> rate = {});

/// Initial velocities of all nodes, without constrained components. Called by `initialise` unless the scene relaxes
/// first.
void start_velocities(const model::Model& model, model::State& state, std::span<const Vec3> velocity,
                      std::span<const Vec3> rate = {});

/// Positions from displacements: after a restart has filled the state.
void update_positions(const model::Model& model, model::State& state);

/// Every array of the state, by name. The registry points into `model` and `state`: both must outlive it.
model::Registry state_registry(const model::Model& model, model::State& state);

}  // namespace brunt::time
