// SPDX-License-Identifier: Apache-2.0
// The nodes in a step: velocities from forces, positions from velocities, and the work that forces do on them.
#pragma once
#include "brunt/contact/list_motion.hpp"
#include "brunt/model/model.hpp"

namespace brunt::time {

/// Mass damping -alpha m v acts on the mean of the velocities before and after the step, so that
///   m (v_after - v_before) = dt_mean f + impulses - a m (v_before + v_after),   a = alpha dt_mean / 2,
///   v_after = [(1 - a) v_before + dt_mean f / m] / (1 + a) + impulses / (m (1 + a)):
/// damping is part of the mobility W = 1 / (m (1 + a)), of order two, stable for any alpha (a < 1 keeps the sign of
/// each velocity), its work -alpha m |v_mean|^2 dt_mean is never positive, and whatever holds a node at rest gives
/// dt_mean f whatever alpha is.
struct Interval {
  double dt = 0;       ///< t_{n+1} - t_n
  double dt_mean = 0;  ///< the time over which forces at t_n act
  double drag = 0;     ///< a, 0 without damping
};

/// v* of all nodes. Free nodes are finished at once (u, x and the work of their forces); those in Model::deferred get
/// v* with fixed and prescribed directions applied, their velocity before is kept in scratch.before. Returns how fast
/// the nodes of this rank are, before and after (zeros where there are no deferred ones).
contact::VelocitySpan predict(const model::Model& model, model::State& state, model::Scratch& scratch,
                              const Interval& step);

/// What a drive gives for the half step from t_n to t_n + dt: its curve in the middle; the mean velocity that ends in
/// the displacement given; the velocity before and the integral of the acceleration since then, over dt_mean.
double driven_component(const model::Drive& given, double before, double time, double dt, double dt_mean);

/// u, x and work of the deferred nodes, after contact has given them their velocity.
void finish_late(const model::Model& model, model::State& state, model::Scratch& scratch, const Interval& step);

}  // namespace brunt::time
