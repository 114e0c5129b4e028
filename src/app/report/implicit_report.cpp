// SPDX-License-Identifier: Apache-2.0
#include "implicit_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "app/watch/element_place.hpp"
#include "implicit/solver.hpp"

namespace brunt::app {
namespace {

std::string text_of(const Prepared& run, const implicit::StabilityChange& change) {
  const std::string when = fmt::format("between t = {:g} and t = {:g}", change.time_before, change.time);
  if (change.directions == implicit::StabilityChange::unknown)
    return fmt::format(
        "the stability of equilibrium at t = {:g} is unknown: its matrix could not be factorised (reported "
        "once)",
        change.time);
  if (change.directions == implicit::StabilityChange::jump)
    return fmt::format(
        "equilibrium jumps {}{}: {:.0f} % of the work in this step is released, so no states of equilibrium lead from "
        "one "
        "to the other, as in snap-through (reported once). A real body moves there with this energy: use smaller steps "
        "to find the limit point, prescribed displacements in place of loads, or scheme: contact_implicit",
        when, change.gid >= 0 ? ", most at " + name_of_node(run, change.gid) : "", 100 * change.released);
  if (change.directions == 0) return fmt::format("equilibrium is stable again: its stability is regained {}", when);
  return fmt::format(
      "equilibrium loses its stability {}: {}{}. The run continues with a state that a real body leaves by buckling or "
      "snapping. To follow the buckled state, give the shape or the load a small imperfection; to follow the motion, "
      "use scheme: contact_implicit (solver.stability: ignore leaves this check out)",
      when,
      change.directions == 1 ? "one small motion releases energy"
                             : fmt::format("{} independent small motions release energy", change.directions),
      change.gid >= 0 ? ", and the most unstable one moves " + name_of_node(run, change.gid) + " most" : "");
}

/// Residuals of each step over the forces that act, and how many of the steps that can be judged were quadratic.
nlohmann::ordered_json newton_summary(const implicit::NewtonTable& table) {
  nlohmann::ordered_json steps = nlohmann::ordered_json::array();
  for (const implicit::NewtonRecord& record : table.last)
    steps.push_back({{"time", record.time}, {"stood", record.stood}, {"residuals", record.ratios}});
  return {{"judged", table.judged},
          {"quadratic", table.quadratic},
          {"share_quadratic",
           table.judged > 0 ? static_cast<double>(table.quadratic) / static_cast<double>(table.judged) : 1.0},
          {"steps", std::move(steps)}};
}

}  // namespace

const char* name_of(model::Scheme scheme) {
  switch (scheme) {
    case model::Scheme::statics:
      return "static";
    case model::Scheme::contact_implicit:
      return "contact_implicit";
    case model::Scheme::hht:
      return "hht";
    case model::Scheme::newmark:
      break;
  }
  return "newmark";
}

std::vector<std::string> warnings_of_stability(Prepared& run) {
  std::vector<std::string> warnings;
  for (const implicit::StabilityChange& change : std::exchange(run.implicit->stability.changes, {}))
    warnings.push_back(text_of(run, change));
  return warnings;
}

double implicit_rounding(const Prepared& run, double extent) {
  return run.implicit->trial.balance.rounding * extent * std::sqrt(static_cast<double>(run.model.mesh.global_nodes));
}

bool walls_make_energy(const Prepared& run, const time::Ledger& ledger, double largest_energy) {
  return run.implicit && run.implicit->settings.scheme != model::Scheme::statics &&
         std::ranges::none_of(run.model.touching.walls, &model::RigidWall::moves) &&
         -ledger.walls > run.input.guards.energy_warning * largest_energy;
}

nlohmann::ordered_json implicit_summary(const Prepared& run) {
  const implicit::Solver& solver = *run.implicit;
  const implicit::Work& work = solver.work;
  const implicit::ContactCounts& counts = solver.contact.counts;
  const bool direct = solver.settings.linear == model::LinearSolver::direct;
  return {{"scheme", name_of(solver.settings.scheme)},
          {"linear", direct ? "direct" : "mumps"},
          {"same_bits_on_any_ranks", direct},
          {"unknowns", solver.unknowns.total},
          {"steps", work.steps},
          {"halved", work.halved},
          {"iterations", work.iterations},
          {"iterations_mean",
           work.steps > 0 ? static_cast<double>(work.iterations) / static_cast<double>(work.steps) : 0.0},
          {"iterations_max", work.most_iterations},
          {"residuals_last", work.newton.last.empty() ? std::vector<double>{} : work.newton.last.back().ratios},
          {"newton", newton_summary(work.newton)},
          {"energy_last", solver.trial.energy},
          {"force_s", work.force_seconds},
          {"contact",
           {{"interfaces", run.model.touching.mortar.size()},
            {"multipliers", solver.contact.z_before.size()},
            {"pairs", counts.pairs},
            {"segments", counts.segments},
            {"active", counts.active}}},
          {"contact_s", work.contact_seconds},
          {"tangent_s", work.tangent_seconds},
          {"factorise_s", work.factorise_seconds},
          {"solve_s", work.solve_seconds},
          {"unstable_directions", static_cast<GlobalIndex>(solver.stability.directions)},
          {"stability_s", work.stability_seconds},
          {"factor_bytes", work.factor_bytes},
          {"factor_flops", work.factor_flops}};
}

}  // namespace brunt::app
