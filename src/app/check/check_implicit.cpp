// SPDX-License-Identifier: Apache-2.0
#include "check_implicit.hpp"

#include <fmt/format.h>

#include <chrono>
#include <cmath>
#include <limits>

#include "app/report/implicit_report.hpp"
#include "implicit/solver.hpp"
#include "implicit/step.hpp"

namespace brunt::app {
namespace {

std::string interface_line(const Prepared& run, const contact::MortarPair& pair) {
  const auto part = [&](std::int32_t block) -> const std::string& { return nth(run.model.blocks, block).part; };
  std::string line = pair.slave == pair.master
                         ? fmt::format("{:<16} {} with itself: ", "mortar", part(pair.slave))
                         : fmt::format("{:<16} {} (slave) and {}: ", "mortar", part(pair.slave), part(pair.master));
  if (pair.tied) return line + "tied";
  line += pair.multiplier == contact::Multiplier::dual ? "dual" : "standard";
  line += pair.enforce == contact::MortarPair::Enforce::lagrange ? " multipliers" : " functions, penalty";
  return line + (pair.friction > 0 ? fmt::format(", friction {:g}", pair.friction) : ", no friction");
}

double steps_until_end(const Prepared& run, double step) {
  double steps = std::numeric_limits<double>::infinity();
  if (run.input.run.end) steps = std::ceil(*run.input.run.end / step * (1 - 1e-9));
  if (run.input.run.steps) steps = std::min(steps, static_cast<double>(*run.input.run.steps));
  return steps;
}

/// The cost of the steps, from the first iteration, which is not solved; or why there is no such iteration.
std::string cost_line(Prepared& run, double steps) {
  constexpr double iterations = 4;  // iterations of a step with contact, mean over the cases
  using Clock = std::chrono::steady_clock;
  const Clock::time_point start = Clock::now();
  const comm::Factorised factors = implicit::factorise_first(implicit_scene(run), *run.implicit);
  const double seconds = run.links.ranks.max(std::chrono::duration<double>(Clock::now() - start).count());
  if (factors.status == comm::FactorStatus::singular)
    return fmt::format(
        "{:<16} none: the stiffness matrix is singular ({} motion{} without resistance); a static state "
        "needs supports, symmetry or ties against each rigid-body motion",
        "first step", factors.null_pivots, factors.null_pivots == 1 ? "" : "s");
  if (!factors.ok())
    return fmt::format("{:<16} none: the stiffness matrix cannot be factorised{}{}", "first step",
                       factors.message.empty() ? "" : ": ", factors.message);
  const int ranks = run.links.ranks.size();
  return fmt::format("{:<16} {} on {} rank{} without output ({:g} iterations a step, {:.2g} s each, measured in one)",
                     "estimated cost", duration_text(steps * iterations * seconds), ranks, ranks == 1 ? "" : "s",
                     iterations, seconds);
}

}  // namespace

std::string duration_text(double seconds) {
  if (seconds < 10) return fmt::format("{:.2g} s", seconds);
  if (seconds < 120) return fmt::format("{:.0f} s", seconds);
  if (seconds < 7200) return fmt::format("{:.0f} min", seconds / 60);
  if (seconds < 1e7) return fmt::format("{:.1f} h", seconds / 3600);
  return fmt::format("{:.3g} days", seconds / 86400);
}

std::vector<std::string> implicit_check(Prepared& run, const std::string& time_unit) {
  const implicit::Solver& solver = *run.implicit;
  const model::ImplicitSolver& settings = solver.settings;
  std::vector<std::string> lines{fmt::format("{:<16} {}, step {:g} {} (from {:g} to {:g}), tolerance {:g}, {}",
                                             "solver", name_of(settings.scheme), settings.step, time_unit,
                                             settings.min_step, settings.max_step, settings.tolerance,
                                             settings.linear == model::LinearSolver::direct ? "direct" : "mumps")};
  for (const implicit::Interface& face : solver.contact.interfaces)
    if (face.first_of_pair) lines.push_back(interface_line(run, face.pair));
  const std::size_t bodies = implicit::body_unknowns * solver.bodies.trial.size();
  lines.push_back(fmt::format("{:<16} {} displacements, {} multipliers{}", "unknowns", solver.unknowns.total,
                              solver.contact.z_before.size(),
                              bodies > 0 ? fmt::format(", {} of rigid bodies", bodies) : ""));
  const double steps = steps_until_end(run, settings.step);
  lines.push_back(fmt::format("{:<16} {:.0f} of that size, unless steps are halved", "steps", steps));
  lines.push_back(cost_line(run, steps));
  return lines;
}

}  // namespace brunt::app
