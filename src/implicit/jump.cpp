// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "comm/exact_sum.hpp"
#include "implicit/balance.hpp"
#include "implicit/data/measure.hpp"
#include "implicit/data/nodal.hpp"
#include "implicit/stability.hpp"
#include "largest_node.hpp"

namespace brunt::implicit {
namespace {

/// Share of the work of a step that must be released before it counts as a jump.
constexpr double released_share = 0.1;
/// Places on the straight way of a step where internal forces are integrated, by Simpson's rule.
constexpr std::size_t intervals = 4;

/// Works on the motion of a step [energy].
struct StepWork {
  double internal = 0;  ///< of the elements' stresses along the straight way
  double coarse = 0;    ///< the same by half of the places
  double least = 0;     ///< that the external forces on the nodes do at least: of those at both ends the smaller one
  double most = 0;      ///< sum of the magnitudes of the larger ones
};

/// Forces of the elements on the nodes, three each, at a share of the way; restores nothing. Collective.
bool forces_on_way(const Scene& scene, Solver& solver, double share, std::vector<double>& forces) {
  std::vector<double> between(solver.trial.displacement.size());
  for (std::size_t i = 0; i < scene.state.nodes.size(); ++i) {
    const Vec3 from = of(scene.state.displacement[i]);
    put(from + share * (of(solver.trial.displacement, i) - from), between, i);
  }
  if (!find_element_forces(scene, solver, between)) return false;
  forces.resize(between.size());
  for (std::size_t i = 0; i < scene.state.nodes.size(); ++i) put(of(scene.scratch.force[i]), forces, i);
  return true;
}

/// Collective. False if an element has no volume on the way.
bool find_works(const Scene& scene, Solver& solver, StepWork& work) {
  std::array<std::vector<double>, intervals + 1> forces;
  forces.front() = solver.memory.internal_force;
  bool found = forces_on_way(scene, solver, 1, forces.back());
  for (std::size_t k = 1; k < intervals && found; ++k)
    found = forces_on_way(scene, solver, static_cast<double>(k) / intervals, forces[k]);
  if (!find_element_forces(scene, solver, solver.trial.displacement)) return false;  // as they were
  if (!found) return false;
  std::array<comm::ExactAccumulator, 4> sums;
  for (const LocalIndex own : solver.unknowns.node) {
    const auto i = static_cast<std::size_t>(own);
    const Vec3 travel = of(solver.trial.displacement, i) - of(scene.state.displacement[i]);
    std::array<double, intervals + 1> done{};
    for (std::size_t k = 0; k <= intervals; ++k) done[k] = -of(forces[k], i).dot(travel);
    sums[0].add((done[0] + 4 * done[1] + 2 * done[2] + 4 * done[3] + done[4]) / 12);
    sums[1].add((done[0] + 4 * done[2] + done[4]) / 6);
    sums[2].add(std::min(done.front(), done.back()));
    sums[3].add(std::max(std::abs(done.front()), std::abs(done.back())));
  }
  std::array<double, 4> value{};
  comm::exact_sum(scene.links.ranks, sums, value);
  work = {value[0], value[1], value[2], value[3]};
  return true;
}

}  // namespace

void watch_jumps(const Scene& scene, Solver& solver) {
  Stability& stability = solver.stability;
  if (!watches_stability(solver.settings) || stability.jumped) return;
  const Measure timed(solver.work.stability_seconds);
  StepWork work;
  if (!find_works(scene, solver, work)) return;
  const double released = work.least - work.internal;
  if (!(released > released_share * work.most + std::abs(work.internal - work.coarse))) return;
  stability.jumped = true;
  std::vector<double> travel(solver.u.size());
  for (std::size_t k = 0; k < solver.unknowns.node.size(); ++k) {
    const auto i = static_cast<std::size_t>(solver.unknowns.node[k]);
    put(of(solver.trial.displacement, i) - of(scene.state.displacement[i]), travel, k);
  }
  StabilityChange change{solver.trial.time_before, solver.trial.time, StabilityChange::jump,
                         largest_node(scene, solver, travel).gid};
  change.released = released / work.most;
  stability.changes.push_back(change);
}

}  // namespace brunt::implicit
