// SPDX-License-Identifier: Apache-2.0
// Criteria by which elements of a part are removed.
#include "read_erosion.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "core/excerpt.hpp"

namespace brunt::scene {
namespace {

using model::Erosion;

const Choices<Erosion::Points> points_words{{{"any", Erosion::Points::any}, {"mean", Erosion::Points::mean}}, {}};
const Choices<bool> bare_nodes{{{"keep", true}, {"drop", false}}, {}};

void judge_erosion(const Key& map, Erosion& erosion) {
  if (erosion.pressure && *erosion.pressure == 0)
    fault(
        at(map, "pressure"),
        "out of range: a pressure of 0 would delete every element; expected a number > 0 (pressure) or < 0 (tension)");
  constexpr std::array criteria{"damage", "plastic_strain", "pressure", "volume", "step"};
  if (std::ranges::none_of(criteria, [&](const char* name) { return has(map, name); }))
    lacking(map, {criteria.begin(), criteria.end()},
            "missing criterion; expected at least one of damage, plastic_strain, pressure, volume, step");
}

}  // namespace

const Table<Erosion> erosion_keys{
    "parts.erosion",
    "a map with damage, plastic_strain, pressure, volume or step",
    {
        {"damage", value(&Erosion::damage, positive), "-", "Damage, at most `critical` of the material."},
        {"plastic_strain", value(&Erosion::plastic_strain, positive), "-",
         "Equivalent plastic strain, of `j2` and the metals."},
        {"pressure", value(&Erosion::pressure, any_number), "stress",
         "Pressure if positive, tension if negative; not 0."},
        {"volume", value(&Erosion::volume, below_one), "-",
         "Volume over the initial volume; elements that fold at a corner are deleted too."},
        {"step", value(&Erosion::step, positive), "time", "Stable step of the element, without `run.cfl`."},
        {"points", value(&Erosion::points, points_words), "-",
         "Whether one integration point suffices, or the mean over the points counts."},
        {"nodes", value(&Erosion::keeps_nodes, bare_nodes), "-",
         "What becomes of nodes without elements, as for `remove`."},
    },
    judge_erosion,
};

void judge_erosion_of_part(const Key& map, const Part& part, const std::map<std::string, material::Law>& materials) {
  const auto found = materials.find(part.material);
  if (!part.erosion || found == materials.end()) return;
  const material::Law& law = found->second;
  const auto* metal = std::get_if<material::Metal>(&law);
  if (material::is_rigid(law)) return fault(map, "invalid for a rigid part; expected a deformable part");
  if (part.erosion->damage && (metal == nullptr || !metal->fracture))
    fault(at(map, "damage"),
          fmt::format("invalid criterion: material '{}' has no damage; expected a material with damage: {{...}}",
                      excerpt(part.material)));
  else if (part.erosion->damage && *part.erosion->damage > metal->fracture->critical)
    fault(at(map, "damage"),
          fmt::format(
              "out of range: {:g} is never reached, since damage ends at critical = {:g}; expected at most that value",
              *part.erosion->damage, metal->fracture->critical));
  if (part.erosion->plastic_strain && metal == nullptr && !std::holds_alternative<material::J2>(law))
    fault(at(map, "plastic_strain"), fmt::format("invalid criterion: material '{}' has no plastic strain; expected a "
                                                 "material of model j2, johnson_cook or another metal",
                                                 excerpt(part.material)));
}

}  // namespace brunt::scene
