// SPDX-License-Identifier: Apache-2.0
#include "implicit/stability.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "implicit/balance.hpp"
#include "implicit/data/measure.hpp"
#include "largest_node.hpp"
#include "symmetric_rows.hpp"

namespace brunt::implicit {
namespace {

/// Eigenvalues above minus this share of the diagonal count as zero: motions that meet no resistance have rounding
/// errors of either sign, below 1e-15. A bar 400 times as long as thick has 3e-11, so its critical load is found to
/// 0.3 %.
constexpr double zero = 1e-13;
constexpr double finer = 16;  ///< steps of the search for the least eigenvalue, above zero and below one
constexpr int inverse_iterations =
    6;  ///< then other eigenvectors are below (1/16)^6 of it, unless they are as unstable

/// S + shift times the scale of its rows.
comm::SparseRows shifted(const SymmetricRows& of, double shift) {
  comm::SparseRows rows = of.rows;
  for (std::size_t r = 0; r < rows.row.size(); ++r)
    for (auto k = static_cast<std::size_t>(rows.begin[r]); k < static_cast<std::size_t>(rows.begin[r + 1]); ++k)
      if (rows.column[k] == rows.row[r]) rows.value[k] += shift * of.scale[r];
  return rows;
}

comm::LinearMethod method_of(model::LinearSolver linear) {
  return linear == model::LinearSolver::direct ? comm::LinearMethod::direct : comm::LinearMethod::mumps;
}

void make_system(const comm::Communicator& ranks, Solver& solver) {
  Stability& stability = solver.stability;
  if (stability.system) return;
  stability.owner_of = owners_of_unknowns(ranks, solver.rows);
  stability.system = std::make_shared<comm::SymmetricSystem>(
      ranks, method_of(solver.settings.linear), static_cast<GlobalIndex>(stability.owner_of.size()), solver.rows.row);
}

/// The direction with the least eigenvalue: inverse iteration with the smallest shift that makes all others positive.
std::vector<double> most_unstable(const Scene& scene, Solver& solver, const SymmetricRows& matrix) {
  comm::SymmetricSystem& system = *solver.stability.system;
  double shift = zero;
  for (comm::Inertia inertia; shift < 1; shift *= finer) {
    inertia = system.factorise(shifted(matrix, shift * finer));
    if (!inertia.found) return {};
    if (inertia.negative <= matrix.expected) break;
  }
  std::vector<double> x(solver.rows.row.size()), b(x.size());
  for (std::size_t r = 0; r < x.size(); ++r) x[r] = std::sin(static_cast<double>(solver.rows.row[r] + 1));
  for (int k = 0; k < inverse_iterations; ++k) {
    for (std::size_t r = 0; r < x.size(); ++r) b[r] = matrix.scale[r] * x[r];
    system.solve(b, x);
    double largest = 0;
    for (const double value : x) largest = std::max(largest, std::abs(value));
    largest = scene.links.ranks.max(largest);
    if (!(largest > 0 && std::isfinite(largest))) return {};
    for (double& value : x) value /= largest;
  }
  return x;
}

/// Motions of the nodes in a direction of the whole system: those of rigid bodies follow them.
void move_carried(const comm::Communicator& ranks, const Solver& solver, std::vector<double>& direction) {
  const RigidBodies& bodies = solver.bodies;
  if (!bodies.any()) return;
  std::vector<double> of_bodies(body_unknowns * bodies.trial.size(), -std::numeric_limits<double>::infinity());
  if (bodies.rows_here)
    std::copy(direction.end() - static_cast<std::ptrdiff_t>(of_bodies.size()), direction.end(), of_bodies.begin());
  ranks.max(of_bodies);
  for (std::size_t own = 0; own < solver.unknowns.node.size(); ++own) {
    if (!bodies.carries(own)) continue;
    const auto b = static_cast<std::size_t>(bodies.place[own].body);
    const Vec3 shift(&of_bodies[body_unknowns * b]), arc(&of_bodies[body_unknowns * b + 3]);
    const Vec3 moved = shift + (arc / bodies.radius[b]).cross(bodies.trial[b].turn_now * bodies.place[own].arm);
    for (std::size_t c = 0; c < 3; ++c) direction[3 * own + c] = moved[static_cast<int>(c)];
  }
}

bool is_due(double step, const Solver& solver) {
  constexpr double slack = 1e-9;  // of a step: rounding of its end
  return std::fmod(step, steps_between_examinations) == 0 || step >= solver.stability.last_step ||
         solver.trial.time + slack * solver.trial.rule.dt >= solver.stability.last_time;
}

}  // namespace

void watch_stability(const Scene& scene, Solver& solver) {
  if (!watches_stability(solver.settings) || !is_due(scene.state.step + 1, solver)) return;
  const Measure timed(solver.work.stability_seconds);
  const comm::Communicator& ranks = scene.links.ranks;
  Stability& stability = solver.stability;
  assemble_tangent(scene, solver, FrictionLimit::given);
  make_system(ranks, solver);
  const SymmetricRows matrix = symmetric_rows(scene, solver);
  const comm::Inertia inertia = stability.system->factorise(shifted(matrix, zero));
  if (!inertia.found) {
    if (!std::exchange(stability.failed, true))
      stability.changes.push_back({stability.examined, solver.trial.time, StabilityChange::unknown, -1});
    return;
  }
  const GlobalIndex directions = std::max(GlobalIndex{0}, inertia.negative - matrix.expected);
  const bool was_stable = stability.directions == 0;
  StabilityChange change{std::exchange(stability.examined, solver.trial.time), solver.trial.time, directions, -1};
  stability.directions = static_cast<double>(directions);
  if (was_stable == (directions == 0)) return;
  if (directions > 0) {
    std::vector<double> direction = most_unstable(scene, solver, matrix);
    if (!direction.empty()) move_carried(ranks, solver, direction);
    if (ranks.any(!direction.empty())) change.gid = largest_node(scene, solver, direction).gid;
  }
  stability.changes.push_back(change);
}

}  // namespace brunt::implicit
