// SPDX-License-Identifier: Apache-2.0
#include "time/step.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "contact/contact.hpp"
#include "core/error.hpp"
#include "force/element_work.hpp"
#include "force/loads.hpp"
#include "force/watched.hpp"
#include "model/curve.hpp"
#include "time/bodies.hpp"
#include "time/motion.hpp"
#include "time/rotations.hpp"
#include "time/sum_forces.hpp"

namespace brunt::time {
namespace {

/// The length of the next step. stable: cfl times the smallest recent stable step of all elements.
double next_dt(const model::State& state, const StepControl& control, double stable) {
  const double grown = control.growth * state.dt;
  if (state.dt == 0 || stable < state.dt) return stable;
  return stable < grown ? state.dt : grown;
}

/// If damping acts at t_n or will act at t_{n+1}, both steps adjacent to that time are bounded: a = alpha dt_mean / 2
/// <= cfl, so that damping alone changes no velocity's sign.
double bounded_by_damping(const model::Model& model, const model::State& state, const StepControl& control, double dt) {
  const bool acts = model.damped() && state.relaxation.under_way == 0 && state.time + dt >= model.loads.damping.from &&
                    state.time < model.loads.damping.to;
  return acts ? std::min(dt, 2 * control.cfl / model.loads.damping.alpha) : dt;
}

void remember_rate(model::State& state, double rate) {
  state.rate_now = std::max(state.rate_now, rate);
  if (std::fmod(state.step, rate_span) != 0) return;
  state.rate_before = state.rate_now;
  state.rate_now = 0;
}

/// Walls are at rest before t = 0.
double wall_speed(const model::RigidWall& wall, const model::State& state, double time) {
  return wall.moves && state.relaxation.under_way == 0 ? model::value_at(wall.motion, time) : 0.0;
}

/// `walls` keeps its storage from step to step.
void place_walls(const model::Model& model, const model::State& state, double time, std::vector<contact::Wall>& walls) {
  walls.clear();
  for (std::size_t w = 0; w < model.touching.walls.size(); ++w) {
    const model::RigidWall& wall = model.touching.walls[w];
    walls.push_back({wall.point + state.wall_position[w] * wall.normal, wall.normal,
                     wall_speed(wall, state, time) * wall.normal, wall.bilateral, wall.friction, wall.blocks});
  }
}

/// v = v* + W G^T impulses on the nodes in contact.
void correct_contact(const model::Model& model, model::State& state, model::Scratch& scratch, Links& links,
                     contact::Contact& contact, const StepReport& step, contact::VelocitySpan velocities) {
  const double dt = step.dt;
  place_walls(model, state, state.time + 0.5 * dt, links.walls);
  carriers_of_bodies(model, scratch, step.drag(), links.carriers, links.coupled);
  const bool flows = contact.derived.elastic_impact && has_flow(model);
  if (flows) sum_flow(model, state, contact.surface.model_node, links.corner_forces, links.flow);
  constexpr int line = sizeof(model::NodeLine) / sizeof(double);
  auto* nodes = reinterpret_cast<double*>(state.nodes.data());
  const contact::StepInput input{
      .position = {nodes, line},
      .old_velocity = {reinterpret_cast<const double*>(scratch.before.data()), 3},
      .velocity = {nodes + 4, line},
      .walls = links.walls,
      .dt = dt,
      .bodies = links.carriers,
      .coupled = links.coupled,
      .flow = flows ? std::span<const double>(links.flow.of_node) : std::span<const double>{},
      .mobility_scale = 1 / (1 + step.drag())};
  {
    const auto timed = links.timers.measure(Phase::search);
    links.ranks.max(velocities);
    contact::search(contact, input, velocities);
  }
  const auto timed = links.timers.measure(Phase::enforcement);
  contact::correct(contact, input);
  if (!model.bodies.empty() && contact.ledger.statistics.last.acted)
    push_bodies(model, contact.step.scratch.enforcement.carried.answer, {step.dt, step.dt_mean, step.drag()}, state,
                scratch);
  if (scratch.contact_impulse.empty()) return;
  // impulses of contact along constrained directions act on the supports
  for (const contact::ConstrainedNode& constrained : model.supports.nodes)
    nth(scratch.contact_impulse, constrained.node).setZero();
  contact::add_impulses(contact, scratch.contact_impulse);
  for (std::size_t k = 0; k < model.supports.nodes.size(); ++k) {
    const contact::ConstrainedNode& constrained = model.supports.nodes[k];
    const Vec3& impulse = nth(scratch.contact_impulse, constrained.node);
    scratch.reaction[k] -= impulse - constrained.free * impulse;
  }
}

}  // namespace

std::vector<contact::Wall> walls_at(const model::Model& model, const model::State& state, double time) {
  std::vector<contact::Wall> walls;
  place_walls(model, state, time, walls);
  return walls;
}

StepReport evaluate(const model::Model& model, model::State& state, model::Scratch& scratch, Links& links,
                    const StepControl& control) {
  StepReport report;
  AssembledStep* assembled = control.assembled;
  const bool due = assembled && estimate_is_due(*assembled, state);
  force::LinearElements linear;
  if (due) linear = force::sized_linear(model);
  {
    const auto timed = links.timers.measure(Phase::element);
    const force::StepWatch watch = assembled ? force::StepWatch{assembled->baseline, linear} : force::StepWatch{};
    report.elements = force::internal_forces(model, state, scratch, watch);
  }
  double reduced[3] = {report.elements.rate, report.elements.inverted_block >= 0 ? 1.0 : 0.0, report.elements.growth};
  {
    const auto timed = links.timers.measure(Phase::halo);
    links.ranks.begin_max(reduced);
    sum_forces(model, state, scratch, links);
    links.ranks.end_max(reduced);
    if (!model.bodies.empty()) sum_body_forces(model, state, scratch, links);
  }
  report.stop = reduced[1] > 0;
  report.bound = report.rate = reduced[0];
  // if run.step is below the bound of the elements, an estimate of the mesh has no benefit
  if (!(control.cfl < control.largest * report.rate)) linear.clear();
  if (due && !report.stop) {
    const auto timed = links.timers.measure(Phase::element);
    estimate(model, state, links, linear, report.rate, *assembled);
  }
  if (assembled) report.bound = bounding_rate(*assembled, state, reduced[2], report.rate);
  const double largest = std::max({report.bound, state.rate_now, state.rate_before});
  const bool all_gone = !(largest > 0) && model.loses_elements();  // then the previous step is kept, if any
  const double kept = state.dt > 0 ? state.dt : std::numeric_limits<double>::infinity();
  report.stable_dt = std::min(all_gone ? kept : control.cfl / largest, control.largest);
  report.dt = bounded_by_damping(model, state, control, next_dt(state, control, report.stable_dt));
  if (!report.stop && !all_gone && !(report.dt > 0 && std::isfinite(report.dt)))
    throw GuardError(
        fmt::format("out of range: the elements bound the step by {:g} at t = {:g}, since their masses or stiffnesses "
                    "are beyond the "
                    "numbers of the machine; expected other units, sizes or materials",
                    report.dt, state.time));
  report.dt_mean = 0.5 * (state.dt + report.dt);
  report.alpha = force::damping_rate(model, state.time);
  // a run that begins in equilibrium: contact has the same impulse in all steps, and no velocity changes
  if (model.relaxes && state.dt == 0) report.dt_mean = report.dt;
  return report;
}

void advance(const model::Model& model, model::State& state, model::Scratch& scratch, Links& links,
             contact::Contact* contact, const StepReport& step) {
  const Interval interval{step.dt, step.dt_mean, step.drag()};
  contact::VelocitySpan velocities;
  {
    const auto timed = links.timers.measure(Phase::other);
    velocities = predict(model, state, scratch, interval);
    if (!model.bodies.empty()) predict_bodies(model, state, scratch, interval, velocities);
  }
  if (!model.turning.empty()) advance_rotations(model, state, scratch, interval);
  if (contact) correct_contact(model, state, scratch, links, *contact, step, velocities);
  const auto timed = links.timers.measure(Phase::other);
  finish_late(model, state, scratch, interval);
  if (!model.bodies.empty()) book_bodies(model, state, scratch, interval);
  if (model.between_parts.booked) force::book_interface(model, state, scratch, step.dt_mean);
  force::book_element_work(model, state, scratch, step.dt_mean);
  if (!model.bodies.empty()) move_bodies(model, state, scratch, step.dt);
  for (std::size_t w = 0; w < model.touching.walls.size(); ++w)
    state.wall_position[w] += step.dt * wall_speed(model.touching.walls[w], state, state.time + 0.5 * step.dt);
  state.time_before = state.time;
  state.time += step.dt;
  state.dt = step.dt;
  ++state.step;
  remember_rate(state, step.bound);
}

}  // namespace brunt::time
