// SPDX-License-Identifier: Apache-2.0
#include "stop_causes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <variant>
#include <vector>

#include "time/relaxation.hpp"

namespace brunt::app {

/// An element keeps its stable step as long as its edges and its volume keep their size.
const char* cause_of_collapse(const ElementPlace& place) {
  constexpr double much = 0.1;
  if (place.shortest_edge < much || place.volume < much)
    return "the element is flattened by a sharp or much smaller body, or by a load that its law cannot carry; use "
           "smaller elements there, or a law that hardens under pressure";
  return "the element is folded or sheared so far that a wave crosses it in a very short time, or its law stiffens "
         "with strain";
}

/// B-bar averages the change of volume over the element. The volume of a single corner is resisted by the deviatoric
/// stress only, which plastic flow limits, so little work inverts the corner.
const char* cause_of_lost_volume(const model::ElementBlock& block) {
  if (block.kind != element::ElementKind::hex8_bbar || !std::holds_alternative<material::J2>(block.law)) return "";
  return ". Likely cause: a concentrated load on a corner of hex8_bbar, which constrains the mean volume of an element "
         "only and yields otherwise; use element: hex8_full, or hex8 with hourglass: {kind: elastic}, for bodies that "
         "hit others with edges and corners";
}

std::string cause_of_given_work(const model::Model& model, GlobalIndex folded) {
  const auto has = [&](auto&& holds) {
    return std::ranges::any_of(model.blocks, [&](const model::ElementBlock& block) { return holds(block.law); });
  };
  const auto has_eos = [](const material::Law& law) {
    const auto* metal = std::get_if<material::Metal>(&law);
    return metal != nullptr && metal->eos.has_value();
  };
  const auto is_hypoelastic = [&](const material::Law& law) {
    return !has_eos(law) && !std::holds_alternative<material::NeoHookean>(law) && !material::is_rigid(law);
  };
  std::vector<std::string> causes;
  if (folded > 0) causes.push_back(fmt::format("{} folded hex8 element{}", folded, folded == 1 ? "" : "s"));
  if (has(has_eos))
    causes.emplace_back(
        "a step in which the pressure of an equation of state changes by much, as in a strong shock: use a smaller "
        "run.cfl, such as 0.3");
  if (has(is_hypoelastic))
    causes.emplace_back(
        "large cyclic strains of a law in rate form, whose stresses have no potential: use neo_hookean, or smaller "
        "elements");
  if (causes.empty()) causes.emplace_back("a step that is too long for the material: use a smaller run.cfl");
  return fmt::format("likely cause: {}", fmt::join(causes, "; or "));
}

std::string cause_among_rigid_bodies(const RigidSources& sources) {
  std::vector<std::string> causes;
  if (sources.contact || sources.walls)
    causes.push_back(fmt::format("contact{} that was not satisfied{}", sources.contact ? "" : " with rigid walls",
                                 sources.at_limit ? " (iterations ended at enforcement.max_iterations)" : ""));
  if (sources.contact) causes.emplace_back("bodies inside each other");
  if (sources.drives) causes.emplace_back("prescribed motions that drive bodies into obstacles");
  if (sources.moving_walls) causes.emplace_back("moving walls that drive bodies into obstacles");
  if (sources.joints)
    causes.emplace_back(
        "joints of bodies that turn by more than a tenth of a radian in a step: use a smaller run.step");
  return causes.empty() ? "unknown, since no body has contact, a drive or a joint"
                        : fmt::format("{}", fmt::join(causes, ", or "));
}

std::string not_at_rest(const model::Relaxation& phase, const scene::Relaxation& asked) {
  return fmt::format(
      "relaxation: not at rest after {} steps (max_steps): {:.0f} % of the loads, unbalanced forces {:.2g} of them, "
      "tolerance {:g}; bodies without supports never come to rest",
      asked.max_steps, 100 * phase.stage / time::relaxation_stages, phase.residual, asked.tolerance);
}

}  // namespace brunt::app
