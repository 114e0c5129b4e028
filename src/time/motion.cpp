// SPDX-License-Identifier: Apache-2.0
#include "time/motion.hpp"

#include <cmath>
#include <limits>
#include <type_traits>

#include "model/curve.hpp"
#include "time/driven_start.hpp"

namespace brunt::time {
namespace {

using model::NodeLine;

/// Dot product of the first three components.
inline double dot(const Quad& a, const Quad& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

inline void book_loads(model::State& state, const model::Scratch& scratch, std::size_t i, double dt_mean,
                       const Quad& twice_mean_v) {
  state.load_work[i] += 0.5 * dt_mean * dot(twice_mean_v, scratch.load[i]);
  for (std::size_t c = 0; c < 3; ++c) state.load_impulse[3 * i + c] += dt_mean * scratch.load[i][c];
}

inline void book_drag(model::State& state, double drag, std::size_t i, const Quad& twice_mean_v) {
  const Quad impulse = -drag * state.nodes[i].mass * twice_mean_v;
  state.damping_work[i] += 0.5 * dot(twice_mean_v, impulse);
  for (std::size_t c = 0; c < 3; ++c) state.load_impulse[3 * i + c] += impulse[c];
}

/// Adds the work of the element forces and moves the node.
inline void move(const Quad& X, const Quad& force, NodeLine& node, Quad& u, double dt, double dt_mean,
                 const Quad& twice_mean_v) {
  const Quad velocity = __builtin_shufflevector(node.v_late(), Quad{}, 0, 1, 2, 7);
  const Quad work{0.0, 0.0, 0.0, 0.5 * dt_mean * dot(twice_mean_v, force)};
  u += dt * velocity + work;
  node.x_mass() = __builtin_shufflevector(X + u, node.x_mass(), 0, 1, 2, 7);
}

/// The smallest and the largest components of velocities, four at a time.
struct Spread {
  Quad low = Quad{} + std::numeric_limits<double>::infinity(), high = -low;
  Quad lost{};  // NaN after any value that is not finite: comparisons would lose it
  void add(const Quad& v) {
    low = v < low ? v : low;
    high = v > high ? v : high;
    lost += 0.0 * v;
  }
  void put(double* to) const {
    for (std::size_t c = 0; c < 3; ++c) {
      const bool finite = lost[c] == 0;
      to[c] = finite ? high[c] : std::numeric_limits<double>::infinity();
      to[c + 3] = finite ? -low[c] : std::numeric_limits<double>::infinity();
    }
  }
};
struct NodeSpread {
  Spread before, after;
};
struct NoSpread {};

/// v_after of a node without contact; the fourth component is unchanged.
template <bool damped>
inline Quad velocity_after(const Quad& before, const Quad& force, double mass, const Interval& step) {
  if constexpr (!damped) return before + (step.dt_mean / mass) * force;  // the fourth component of forces is zero
  const double share = 1 / (1 + step.drag);
  const Quad after = share * (1 - step.drag) * before + (share * step.dt_mean / mass) * force;
  return __builtin_shufflevector(after, before, 0, 1, 2, 7);
}

template <bool loaded, bool damped, class Velocities>
void predict_all(const model::Model& model, model::State& state, model::Scratch& scratch, const Interval& step,
                 Velocities& velocities) {
  for (std::size_t i = 0; i < state.nodes.size(); ++i) {
    NodeLine& node = state.nodes[i];
    Quad force = scratch.force[i];
    if constexpr (loaded) force += scratch.load[i];
    const Quad before = node.v_late();
    const Quad after = velocity_after<damped>(before, force, node.mass, step);
    node.v_late() = after;
    if constexpr (!std::is_same_v<Velocities, NoSpread>) {
      velocities.before.add(before);
      velocities.after.add(after);
    }
    if (damped || node.deferred != 0.0) scratch.before[i] = Vec3(before[0], before[1], before[2]);
    if (node.deferred != 0.0) continue;
    if constexpr (loaded) book_loads(state, scratch, i, step.dt_mean, before + after);
    if constexpr (damped) book_drag(state, step.drag, i, before + after);
    move(model.reference[i], scratch.force[i], node, state.displacement[i], step.dt, step.dt_mean, before + after);
  }
}

template <class Velocities>
void predict_nodes(const model::Model& model, model::State& state, model::Scratch& scratch, const Interval& step,
                   Velocities& velocities) {
  if (model.damped())
    predict_all<true, true>(model, state, scratch, step, velocities);
  else if (model.loaded())
    predict_all<true, false>(model, state, scratch, step, velocities);
  else
    predict_all<false, false>(model, state, scratch, step, velocities);
}

/// What the drives of a constrained node give its velocity at the next half step; nothing before t = 0.
Vec3 driven_velocity(const model::Model& model, const model::State& state, const std::array<std::int32_t, 3>& drives,
                     const Vec3& before, double dt, double dt_mean) {
  Vec3 velocity = Vec3::Zero();
  if (state.relaxation.under_way != 0) return velocity;
  for (int c = 0; c < 3; ++c) {
    const std::int32_t drive = nth(drives, c);
    if (drive >= 0)
      velocity[c] = driven_component(nth(model.supports.drives, drive), before[c], state.time, dt, dt_mean);
  }
  return velocity;
}

}  // namespace

double driven_component(const model::Drive& given, double before, double time, double dt, double dt_mean) {
  using Gives = model::Drive::Gives;
  switch (given.gives) {
    case Gives::displacement:
      return given.scale * (model::value_at(given.curve, time + dt) - model::value_at(given.curve, time)) / dt;
    case Gives::acceleration:
      return before + given.scale * model::integral(given.curve, time + 0.5 * dt - dt_mean, time + 0.5 * dt);
    case Gives::velocity:
      break;
  }
  return given.scale * model::value_at(given.curve, time + 0.5 * dt);
}

double driven_start(const model::Drive& drive, double initial) {
  using Gives = model::Drive::Gives;
  if (drive.gives == Gives::acceleration) return initial;
  const double begins = drive.scale * (drive.gives == Gives::displacement ? model::slope_after(drive.curve, 0)
                                                                          : model::value_at(drive.curve, 0));
  return std::abs(initial) > same_speed * std::abs(begins) ? begins : 0;
}

contact::VelocitySpan predict(const model::Model& model, model::State& state, model::Scratch& scratch,
                              const Interval& step) {
  if (model.deferred.empty()) {
    NoSpread nothing;
    predict_nodes(model, state, scratch, step, nothing);
    return {};
  }
  NodeSpread velocities;
  predict_nodes(model, state, scratch, step, velocities);
  for (std::size_t k = 0; k < model.supports.nodes.size(); ++k) {
    const contact::ConstrainedNode& constrained = model.supports.nodes[k];
    NodeLine& node = nth(state.nodes, constrained.node);
    if (node.is_dropped()) {
      scratch.reaction[k].setZero();
      continue;
    }
    Eigen::Map<Vec3> v(node.v);
    const Vec3 given = driven_velocity(model, state, model.supports.drive[k], nth(scratch.before, constrained.node),
                                       step.dt, step.dt_mean);
    const Vec3 allowed = constrained.free * v + given;
    scratch.reaction[k] = (1 + step.drag) * node.mass * (allowed - v);
    v = allowed;
    velocities.after.add(node.v_late());
  }
  contact::VelocitySpan span;
  velocities.before.put(span.data());
  velocities.after.put(span.data() + 6);
  return span;
}

namespace {

/// Deferred nodes are scattered in memory, and the nodal data exceed the cache: prefetches the data of a node.
inline void fetch(const model::Model& model, const model::State& state, const model::Scratch& scratch, std::size_t i) {
  __builtin_prefetch(&state.nodes[i], 1);
  __builtin_prefetch(&state.displacement[i], 1);
  __builtin_prefetch(&model.reference[i]);
  __builtin_prefetch(&scratch.force[i]);
  __builtin_prefetch(&scratch.before[i]);
}

/// Nodes removed with their last element, whose forces act a last time: no supports, no damping, no contact.
void fly_on(const model::Model& model, model::State& state, const model::Scratch& scratch, const Interval& step) {
  for (const LocalIndex dropped : state.living.dropped) {
    const auto i = static_cast<std::size_t>(dropped);
    NodeLine& node = state.nodes[i];
    const Vec3& v = scratch.before[i];
    const Quad before{v[0], v[1], v[2], node.deferred};
    Quad force = scratch.force[i];
    if (model.loaded()) force += scratch.load[i];
    node.v_late() = velocity_after<false>(before, force, node.mass, step);
    const Quad twice_mean_v = before + node.v_late();
    if (model.loaded()) book_loads(state, scratch, i, step.dt_mean, twice_mean_v);
    move(model.reference[i], scratch.force[i], node, state.displacement[i], step.dt, step.dt_mean, twice_mean_v);
  }
}

}  // namespace

void finish_late(const model::Model& model, model::State& state, model::Scratch& scratch, const Interval& step) {
  constexpr std::size_t ahead = 8;
  std::size_t next_constrained = 0;
  for (std::size_t k = 0; k < model.deferred.size(); ++k) {
    if (k + ahead < model.deferred.size())
      fetch(model, state, scratch, static_cast<std::size_t>(model.deferred[k + ahead]));
    const auto i = static_cast<std::size_t>(model.deferred[k]);
    NodeLine& node = state.nodes[i];
    const bool constrained = next_constrained < model.supports.nodes.size() &&
                             model.supports.nodes[next_constrained].node == model.deferred[k];
    if (node.is_dropped()) {
      next_constrained += constrained ? 1 : 0;
      continue;
    }
    const Vec3& before = scratch.before[i];
    const Quad twice_mean_v = node.v_late() + Quad{before[0], before[1], before[2]};
    if (model.loaded()) book_loads(state, scratch, i, step.dt_mean, twice_mean_v);
    if (model.damped()) book_drag(state, step.drag, i, twice_mean_v);
    if (constrained) {
      const Vec3& reaction = scratch.reaction[next_constrained];
      state.reaction_work[i] += 0.5 * dot(twice_mean_v, Quad{reaction[0], reaction[1], reaction[2]});
      for (int c = 0; c < 3; ++c) state.reaction_impulse[3 * i + static_cast<std::size_t>(c)] += reaction[c];
      ++next_constrained;
    }
    move(model.reference[i], scratch.force[i], node, state.displacement[i], step.dt, step.dt_mean, twice_mean_v);
  }
  fly_on(model, state, scratch, step);
}

}  // namespace brunt::time
