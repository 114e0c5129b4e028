// SPDX-License-Identifier: Apache-2.0
// Rigid bodies in the phase before t = 0 (relaxation.hpp): the same operations as for nodes.
#pragma once
#include "model/model.hpp"

namespace brunt::time {

/// For each node, whether it belongs to a body; empty if there are no bodies.
[[nodiscard]] std::vector<char> nodes_of_bodies(const model::Model& model);

/// [energy]
[[nodiscard]] double kinetic_energy_of_bodies(const model::Model& model, const model::State& state);

/// Scales the loads of a stage.
void scale_body_loads(double share, model::Scratch& scratch);

/// Squares of the unbalanced forces on bodies and of their loads [force^2], after a step of `dt_mean`. Moments count as
/// forces at the radius of gyration.
struct BodyBalance {
  double left = 0, given = 0;
};
[[nodiscard]] BodyBalance balance_of_bodies(const model::Model& model, const model::Scratch& scratch, double dt_mean);

/// Stores the constraint forces on the bodies in the last step: all changes of their momenta except those by forces of
/// elements and loads.
void keep_held_wrenches(const model::Model& model, const model::Scratch& scratch, double dt_mean, model::State& state);

/// Brings the bodies to rest at x_n: half a step earlier they have minus the velocity that the forces produce until
/// then.
void stop_bodies(const model::Model& model, const model::Scratch& scratch, double dt_mean, model::State& state);

/// Adds half a step's work of the elements' forces of t_n on the bodies, which belongs to them and not to their nodes.
/// after: the half step after t_n, otherwise the one before it.
void add_work_on_bodies(const model::Model& model, const model::Scratch& scratch, double half_step, bool after,
                        model::State& state);

/// The accounts of a run that begins with energy stored in the elements.
void begin_accounts_of_bodies(model::State& state);

}  // namespace brunt::time
