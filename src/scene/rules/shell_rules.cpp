// SPDX-License-Identifier: Apache-2.0
// What parts of shells may not have: laws, contact, solvers, criteria of erosion.
#include <algorithm>

#include "core/excerpt.hpp"
#include "scene/build/build.hpp"
#include "scene/build/rigid_parts.hpp"
#include "scene/reported.hpp"
#include "scene/rules/rules.hpp"

namespace brunt::scene {
namespace {

using Lines = std::vector<std::string>;

/// What a shell cannot have of this law; empty if it can have all.
std::string no_law_of_shells(const material::Law& law) {
  if (std::holds_alternative<material::NeoHookean>(law)) return "model: neo_hookean";
  if (std::holds_alternative<material::Foam>(law)) return "model: crushable_foam";
  if (const auto* metal = std::get_if<material::Metal>(&law)) {
    if (std::holds_alternative<material::LinearStrength>(metal->strength)) return "model: hydrodynamic";
    if (metal->eos) return "an equation of state (eos)";
  }
  const auto* elastic = std::get_if<material::Elastic>(&law);
  const auto* j2 = std::get_if<material::J2>(&law);
  const material::StressRate rate = elastic != nullptr ? elastic->stress_rate
                                    : j2 != nullptr    ? j2->stress_rate
                                                       : material::StressRate::jaumann;
  return rate == material::StressRate::logarithmic ? "stress_rate: logarithmic" : "";
}

void judge_law(const Input& input, const Part& part, Lines& faults) {
  const auto law = input.materials.find(part.material);
  if (law == input.materials.end()) return;
  if (const std::string what = no_law_of_shells(law->second); !what.empty())
    faults.push_back(reported(input, fmt::format("parts.{}.material", part.name),
                              "invalid material '{}': shells do not have {}; expected elastic, j2, piecewise_linear, "
                              "johnson_cook without eos, or rigid",
                              excerpt(part.material), what));
}

/// One line for each entry of `contact` by which a part of shells would have contact.
void judge_contact(const Input& input, Lines& faults) {
  std::vector<char> told(input.contact.size(), 0);
  for (const Part& part : input.parts)
    for (const Part& other : input.parts) {
      const std::optional<std::size_t> entry = deciding_entry(input, part.name, other.name);
      if (!is_shell(part) || !entry || told[*entry] != 0) continue;
      told[*entry] = 1;
      const bool all = input.contact[*entry].between.empty();
      faults.push_back(reported(
          input, fmt::format("contact.{}", *entry),
          "invalid contact: part '{}' has shells, whose contact and ties do not exist in this version; expected {}",
          excerpt(part.name),
          all ? fmt::format("between: [a, b] with solid parts, or exclude with all pairs of '{0}', [{0}, {0}] too",
                            excerpt(part.name))
              : "solid parts"));
    }
}

/// Moments on nodes need nodes of shells.
void judge_moments(const Input& input, bool any_shell, Lines& faults) {
  for (std::size_t k = 0; k < input.forces.size(); ++k)
    if (input.forces[k].moment != Vec3::Zero() && (!any_shell || names_rigid_part(input, input.forces[k].where)))
      faults.push_back(reported(input, fmt::format("forces.{}.moment", k),
                                "invalid moment: only nodes of shells rotate; expected nodes of a part of shells"));
}

}  // namespace

std::vector<std::string> faults_of_shells(const Input& input) {
  Lines faults;
  const bool any_shell = std::ranges::any_of(input.parts, is_shell);
  judge_moments(input, any_shell, faults);
  if (!any_shell) return faults;
  const Part& first = *std::ranges::find_if(input.parts, is_shell);
  if (input.implicit)
    faults.push_back(reported(input, "solver",
                              "invalid: part '{}' has shells, which implicit scenes do not have in this version; "
                              "expected no solver, or solid elements",
                              excerpt(first.name)));
  for (const Part& part : input.parts) {
    if (!is_shell(part)) continue;
    judge_law(input, part, faults);
    if (part.erosion && part.erosion->volume)
      faults.push_back(reported(input, fmt::format("parts.{}.erosion.volume", part.name),
                                "invalid criterion of shells, whose thickness follows their strain; expected damage, "
                                "plastic_strain, pressure or step"));
  }
  judge_contact(input, faults);
  return faults;
}

}  // namespace brunt::scene
