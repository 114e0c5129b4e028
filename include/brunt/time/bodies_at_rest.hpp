// SPDX-License-Identifier: Apache-2.0
// Rigid bodies in the phase before t = 0 (relaxation.hpp): what the phase does to nodes, done to bodies.
#pragma once
#include "brunt/model/model.hpp"

namespace brunt::time {

/// By node, whether a body carries it; empty where there are no bodies.
[[nodiscard]] std::vector<char> nodes_of_bodies(const model::Model& model);

/// [energy]
[[nodiscard]] double kinetic_energy_of_bodies(const model::Model& model, const model::State& state);

/// Loads of a stage.
void scale_body_loads(double share, model::Scratch& scratch);

/// Squares of what is left of the forces on bodies and of their loads [force^2], after a step of `dt_mean`. Moments
/// count as forces at the radius of gyration.
struct BodyBalance {
  double left = 0, given = 0;
};
[[nodiscard]] BodyBalance balance_of_bodies(const model::Model& model, const model::Scratch& scratch, double dt_mean);

/// What held the bodies in the step just taken: all that changed their momenta but forces of elements and loads.
void keep_held_wrenches(const model::Model& model, const model::Scratch& scratch, double dt_mean, model::State& state);

/// Lets the bodies be at rest at x_n: half a step before they have minus what the forces give until then.
void stop_bodies(const model::Model& model, const model::Scratch& scratch, double dt_mean, model::State& state);

/// Adds half a step's work of the elements' forces of t_n on the bodies, which belongs to them and not to their nodes.
/// after: of the half step behind t_n, else before it.
void add_work_on_bodies(const model::Model& model, const model::Scratch& scratch, double half_step, bool after,
                        model::State& state);

/// The accounts of a run that begins with the energy that elements have stored.
void begin_accounts_of_bodies(model::State& state);

}  // namespace brunt::time
