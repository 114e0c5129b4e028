// SPDX-License-Identifier: Apache-2.0
#include "implicit/step.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "acceleration.hpp"
#include "comm/exact_sum.hpp"
#include "comm/newton.hpp"
#include "core/error.hpp"
#include "implicit/balance.hpp"
#include "implicit/commit.hpp"
#include "implicit/data/measure.hpp"
#include "largest_node.hpp"

namespace brunt::implicit {
namespace {

/// Share of the energy taken by contact so far that its recovery may return in a step, estimated with the previous
/// pressures.
constexpr double of_taken = 0.5;

/// Newton's iteration of one step and its final state.
struct Attempt {
  comm::NewtonResult newton;
  comm::Factorised factors;
  int formed = 0;                ///< factorisations
  LargestNode worst;             ///< with the largest unbalanced force
  std::vector<double> floating;  ///< a null direction of the matrix, if it was singular
};

/// The step length of a correction. Active sets and branches of friction change in the first iterations, which may
/// increase the residual temporarily: these corrections are full. A later correction that increases the residual
/// belongs to a cycle (nodes of small pressure whose slip direction alternates): it is halved until the residual
/// decreases.
double share_of(const comm::NewtonStep& step, const Trial& trial) {
  constexpr int full_steps = 4, halvings = 5;
  if (step.iteration < full_steps) return 1;
  const double before = trial.balance.left;
  std::vector<double> residual(step.residual.size());
  double best_share = 1, best = std::numeric_limits<double>::infinity();
  for (double share = 1; share > std::exp2(-halvings); share *= 0.5) {
    if (!step.residual_at(share, residual)) continue;
    if (trial.balance.left < before) return share;
    if (trial.balance.left < best) {
      best = trial.balance.left;
      best_share = share;
    }
  }
  return best_share;
}

/// Collective.
void note_iterate(const Scene& scene, Solver& solver) {
  Trial& trial = solver.trial;
  trial.ratios.push_back(trial.balance.given > 0 ? trial.balance.left / trial.balance.given : 0.0);
  std::vector<std::uint8_t> now = branches(solver.contact);
  add_branches(solver.walls, now);
  trial.stood.push_back(scene.links.ranks.any(now != trial.branches) ? 0 : 1);
  trial.branches = std::move(now);
}

NewtonRecord record_of(const Trial& trial) {
  const std::size_t k = last_judged(trial.ratios);
  return {trial.time, trial.ratios, trial.stood[k] != 0};
}

/// Whether the factors of an earlier iterate do as well as new ones, where second derivatives are missing in both: the
/// branches stand, and the residual falls by as much as the missing part lets it. Walls choose by the last matrix.
bool keeps_factors(const Solver& solver) {
  constexpr double near = 1e-2, falls = 0.5;
  const std::vector<double>& ratios = solver.trial.ratios;
  return !solver.walls.any() && solver.trial.stood.back() != 0 && ratios.back() < near &&
         ratios.back() < falls * ratios[ratios.size() - 2];
}

bool form_factors(const Scene& scene, Solver& solver, Attempt& attempt) {
  attempt.factors = factorise_tangent(scene, solver);
  ++attempt.formed;
  solver.work.factor_bytes = std::max(solver.work.factor_bytes, attempt.factors.memory);
  solver.work.factor_flops = std::max(solver.work.factor_flops, attempt.factors.operations);
  if (attempt.factors.status == comm::FactorStatus::singular) attempt.floating = solver.system.null_direction();
  return attempt.factors.ok();
}

Attempt iterate(const Scene& scene, Solver& solver) {
  Attempt attempt;
  Trial& trial = solver.trial;
  comm::NewtonProblem problem;
  Acceleration acceleration;
  const bool inexact = std::ranges::any_of(solver.contact.interfaces, &Interface::consistent);
  problem.residual = [&](std::span<const double> u, std::span<double> residual) {
    const Measure timed(solver.work.force_seconds);
    if (!find_forces(scene, solver, u)) return false;
    balance(scene, solver, residual);
    return true;
  };
  problem.judge = [&](int iteration, std::span<const double>, std::span<const double> residual) {
    const Balance& now = trial.balance;
    note_iterate(scene, solver);
    if (now.left <= std::max(solver.settings.tolerance * now.given, now.rounding) &&
        chosen_by_balance(scene.links.ranks, solver.walls))
      return comm::NewtonVerdict::converged;
    if (iteration < most_iterations && std::isfinite(now.left)) return comm::NewtonVerdict::go_on;
    attempt.worst = largest_node(scene, solver, residual);
    return comm::NewtonVerdict::give_up;
  };
  problem.solve = [&](std::span<const double>, std::span<const double> residual, std::span<double> correction) {
    const bool kept = inexact && attempt.formed > 0 && keeps_factors(solver);
    if (!kept && !form_factors(scene, solver, attempt)) return false;
    const Measure timed(solver.work.solve_seconds);
    (void)solver.system.solve(residual, correction);
    if (inexact) {
      if (trial.stood.back() == 0) acceleration.forget();
      acceleration.improve(scene.links.ranks, 3 * solver.unknowns.node.size(), correction);
    }
    std::array<comm::ExactAccumulator, 1> sum;
    for (std::size_t k = 0; k < residual.size(); ++k) sum[0].add(residual[k] * correction[k]);
    std::array<double, 1> energy{};
    comm::exact_sum(scene.links.ranks, sum, energy);
    trial.energy = energy[0];
    return true;
  };
  if (solver.contact.any() || solver.walls.any())
    problem.step_length = [&](const comm::NewtonStep& step) {
      const double share = share_of(step, trial);
      acceleration.took(share);
      return share;
    };
  attempt.newton = comm::newton(scene.links.ranks, solver.u, problem);
  return attempt;
}

std::string cause_of(const Attempt& attempt, const Trial& trial, double tolerance) {
  switch (attempt.newton.reason) {
    case comm::NewtonReason::inadmissible:
      return "an element loses its volume during the iteration";
    case comm::NewtonReason::singular:
      return "the stiffness matrix is singular: the body has lost its stability or lacks supports";
    default:
      break;
  }
  return fmt::format("unbalanced forces are {:.2g} of the acting ones after {} iterations (solver.tolerance {:g})",
                     trial.ratios.empty() ? 1.0 : trial.ratios.back(), attempt.newton.iterations, tolerance);
}

/// Failures that a shorter step cannot avoid.
void refuse_hopeless(const Scene& scene, const Solver& solver, const Attempt& attempt,
                     const std::function<std::string(GlobalIndex)>& place) {
  using comm::FactorStatus;
  const FactorStatus status = attempt.factors.status;
  if (status == FactorStatus::out_of_memory || status == FactorStatus::failed)
    throw MachineError("the linear solver failed: " + attempt.factors.message);
  if (status != FactorStatus::singular || solver.settings.scheme != model::Scheme::statics) return;
  if (attempt.newton.iterations > 0 || scene.links.ranks.max(static_cast<GlobalIndex>(attempt.floating.size())) == 0)
    return;
  const LargestNode most = largest_node(scene, solver, attempt.floating);
  throw GuardError(
      fmt::format("{} can move freely at t = {:g}, step {}: missing supports ({} motion{} without resistance). A "
                  "static state needs supports, symmetry or ties against each rigid-body motion",
                  place(most.gid), scene.state.time, static_cast<GlobalIndex>(scene.state.step),
                  attempt.factors.null_pivots, attempt.factors.null_pivots == 1 ? "" : "s"));
}

[[noreturn]] void stop_of_objection(const Scene& scene, const Solver& solver, const std::string& objection) {
  throw GuardError(
      fmt::format("bodies pass into each other or into walls at t = {:g}, step {}, with the smallest step {:g} "
                  "(solver.min_step {:g}): {}",
                  scene.state.time, static_cast<GlobalIndex>(scene.state.step), solver.trial.rule.dt,
                  solver.settings.min_step, objection));
}

[[noreturn]] void stop(const Scene& scene, const Solver& solver, const Attempt& attempt,
                       const std::function<std::string(GlobalIndex)>& place) {
  throw GuardError(fmt::format(
      "Newton's method fails at t = {:g}, step {}, with the smallest step {:g} (solver.min_step {:g}): {}{}{}",
      scene.state.time, static_cast<GlobalIndex>(scene.state.step), solver.trial.rule.dt, solver.settings.min_step,
      cause_of(attempt, solver.trial, solver.settings.tolerance),
      attempt.worst.gid >= 0 ? fmt::format("; the largest unbalanced force is at {}, {:.3g} [force]",
                                           place(attempt.worst.gid), attempt.worst.size)
                             : "",
      solver.stability.directions > 0 ? "; the last state that was examined is unstable" : ""));
}

/// Contact may return at most the energy that it has taken, so the energy of the bodies never exceeds the initial one.
bool gives_too_much(const Solver& solver) {
  return solver.contact.recovery > 0 && solver.contact.budget > 0 &&
         given_in_step(solver.contact) > std::max(0.0, solver.contact_account.normal);
}

}  // namespace

comm::Factorised factorise_first(const Scene& scene, Solver& solver) {
  begin_step(scene, solver, step_of(solver.settings, solver.memory.length),
             next_time(solver.settings, solver.memory.length));
  comm::Factorised factors;
  factors.status = comm::FactorStatus::not_finite;
  std::vector<double> residual(solver.u.size());
  if (find_forces(scene, solver, solver.u)) {
    balance(scene, solver, residual);
    factors = factorise_tangent(scene, solver);
  }
  give_back(scene, solver);
  return factors;
}

void advance(const Scene& scene, Solver& solver, const std::function<std::string(GlobalIndex gid)>& place,
             const std::function<std::string()>& objection) {
  StepLength& length = solver.memory.length;
  bool recovers = true;
  for (;;) {
    solver.contact.budget = recovers ? of_taken * std::max(0.0, solver.contact_account.normal) : 0.0;
    begin_step(scene, solver, step_of(solver.settings, length), next_time(solver.settings, length));
    const Attempt attempt = iterate(scene, solver);
    solver.work.iterations += attempt.newton.iterations;
    const bool converged = attempt.newton.reason == comm::NewtonReason::converged;
    if (recovers && (!converged || gives_too_much(solver))) {
      const bool asked = solver.contact.recovery > 0 && solver.contact.budget > 0;
      recovers = false;
      if (asked) {
        give_back(scene, solver);
        continue;
      }
    }
    const std::string objected = converged && objection ? objection() : std::string();
    if (converged && objected.empty()) {
      watch_stability(scene, solver);
      watch_jumps(scene, solver);
      commit_step(scene, solver);
      count_step(solver.settings, attempt.formed, length);  // as many as iterations, unless factors are kept
      ++solver.work.steps;
      solver.work.most_iterations = std::max(solver.work.most_iterations, GlobalIndex{attempt.newton.iterations});
      add(solver.work.newton, record_of(solver.trial));
      return;
    }
    give_back(scene, solver);
    if (!converged) refuse_hopeless(scene, solver, attempt, place);
    if (!halve(solver.settings, length)) {
      if (converged) stop_of_objection(scene, solver, objected);
      stop(scene, solver, attempt, place);
    }
    ++solver.work.halved;
    recovers = true;
  }
}

}  // namespace brunt::implicit
