// SPDX-License-Identifier: Apache-2.0
// The nodes in a step: velocities from forces, positions from velocities, and the work that forces do on them.
#pragma once
#include "brunt/contact/list_motion.hpp"
#include "brunt/model/model.hpp"

namespace brunt::time {

/// v* of all nodes. Free nodes are finished at once (u, x and the work of their forces); those in Model::late get v*
/// with fixed and prescribed directions applied, their velocity before is kept in scratch.before. Returns how fast the
/// nodes of this rank are, before and after (zeros where there are no late ones).
contact::VelocitySpan predict(const model::Model& model, model::State& state, model::Scratch& scratch, double dt,
                              double dt_mean);

/// u, x and work of the late nodes, after contact has given them their velocity.
void finish_late(const model::Model& model, model::State& state, model::Scratch& scratch, double dt, double dt_mean);

}  // namespace brunt::time
