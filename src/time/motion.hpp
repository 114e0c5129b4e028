// SPDX-License-Identifier: Apache-2.0
// The nodes in a step: velocities from forces, positions from velocities, and the work of forces on them.
#pragma once
#include "contact/lists/list_motion.hpp"
#include "model/model.hpp"

namespace brunt::time {

/// Mass damping -alpha m v acts on the mean of the velocities before and after the step, so that
///   m (v_after - v_before) = dt_mean f + impulses - a m (v_before + v_after),   a = alpha dt_mean / 2,
///   v_after = [(1 - a) v_before + dt_mean f / m] / (1 + a) + impulses / (m (1 + a)):
/// damping is part of the mobility W = 1 / (m (1 + a)). It is of second order and stable for any alpha (a < 1 preserves
/// the sign of each velocity). Its work -alpha m |v_mean|^2 dt_mean is never positive, and a force that holds a node at
/// rest gives dt_mean f independent of alpha.
struct Interval {
  double dt = 0;       ///< t_{n+1} - t_n
  double dt_mean = 0;  ///< the time over which forces at t_n act
  double drag = 0;     ///< a, 0 without damping
};

/// v* of all nodes. Free nodes are finished at once (u, x and the work of their forces). Nodes in Model::deferred get
/// v* with fixed and prescribed directions applied, and their previous velocity is kept in scratch.before. Returns the
/// range of the velocities of this rank's nodes, before and after (zeros if there are no deferred nodes).
contact::VelocitySpan predict(const model::Model& model, model::State& state, model::Scratch& scratch,
                              const Interval& step);

/// The prescribed value of a drive for the half step from t_n to t_n + dt: its curve at the middle; the mean velocity
/// that ends in the prescribed displacement; or the velocity before plus the integral of the acceleration over dt_mean.
double driven_component(const model::Drive& given, double before, double time, double dt, double dt_mean);

/// u, x and work of the deferred nodes, after contact has determined their velocity.
void finish_late(const model::Model& model, model::State& state, model::Scratch& scratch, const Interval& step);

}  // namespace brunt::time
