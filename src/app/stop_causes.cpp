// SPDX-License-Identifier: Apache-2.0
#include "stop_causes.hpp"

#include <fmt/format.h>

#include <variant>

#include "brunt/time/relaxation.hpp"

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

std::string not_at_rest(const model::Relaxation& phase, const scene::Relaxation& asked) {
  return fmt::format(
      "relaxation: not at rest after {} steps (max_steps): {:.0f} % of the loads, unbalanced forces {:.2g} of them, "
      "tolerance {:g}; bodies without supports never come to rest",
      asked.max_steps, 100 * phase.stage / time::relaxation_stages, phase.residual, asked.tolerance);
}

}  // namespace brunt::app
