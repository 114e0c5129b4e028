// SPDX-License-Identifier: Apache-2.0
// Criteria by which elements of a part are removed.
#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "core/excerpt.hpp"
#include "scene/read/sections.hpp"

namespace brunt::scene {

model::Erosion read_erosion(const Key& key) {
  model::Erosion erosion;
  Section section(key, "a map with damage, plastic_strain, pressure, volume or step");
  section.optional("damage", erosion.damage, positive);
  section.optional("plastic_strain", erosion.plastic_strain, positive);
  section.optional("pressure", erosion.pressure, any_number);
  section.optional("volume", erosion.volume, below_one);
  section.optional("step", erosion.step, positive);
  if (erosion.pressure && *erosion.pressure == 0)
    fault(
        section.at("pressure"),
        "out of range: a pressure of 0 would delete every element; expected a number > 0 (pressure) or < 0 (tension)");
  static const Choices<model::Erosion::Points> points{
      {{"any", model::Erosion::Points::any}, {"mean", model::Erosion::Points::mean}}, {}};
  section.optional("points", erosion.points, points);
  static const Choices<bool> nodes{{{"keep", true}, {"drop", false}}, {}};
  section.optional("nodes", erosion.keeps_nodes, nodes);
  constexpr std::array criteria{"damage", "plastic_strain", "pressure", "volume", "step"};
  if (section.is_map() && std::ranges::none_of(criteria, [&](const char* name) { return section.has(name); }))
    lacking(key, {"damage", "plastic_strain", "pressure", "volume", "step"},
            "missing criterion; expected at least one of damage, plastic_strain, pressure, volume, step");
  return erosion;
}

void check_erosion(const Input& input, const Part& part, const Key& key) {
  const auto found = input.materials.find(part.material);
  if (!part.erosion || found == input.materials.end()) return;
  const material::Law& law = found->second;
  const auto* metal = std::get_if<material::Metal>(&law);
  Section section(key, "a map");
  for (const char* name : {"damage", "plastic_strain", "pressure", "volume", "step", "points", "nodes"})
    section.has(name);
  if (material::is_rigid(law)) return fault(key, "invalid for a rigid part; expected a deformable part");
  if (part.erosion->damage && (metal == nullptr || !metal->fracture))
    fault(section.at("damage"),
          fmt::format("invalid criterion: material '{}' has no damage; expected a material with damage: {{...}}",
                      excerpt(part.material)));
  else if (part.erosion->damage && *part.erosion->damage > metal->fracture->critical)
    fault(section.at("damage"),
          fmt::format(
              "out of range: {:g} is never reached, since damage ends at critical = {:g}; expected at most that value",
              *part.erosion->damage, metal->fracture->critical));
  if (part.erosion->plastic_strain && metal == nullptr && !std::holds_alternative<material::J2>(law))
    fault(section.at("plastic_strain"), fmt::format("invalid criterion: material '{}' has no plastic strain; expected "
                                                    "a material of model j2, johnson_cook or another metal",
                                                    excerpt(part.material)));
}

}  // namespace brunt::scene
