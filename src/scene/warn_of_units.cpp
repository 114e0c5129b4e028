// SPDX-License-Identifier: Apache-2.0
// Are a material's figures plausible in the scene's units? Mixed-up units are the commonest mistake that runs.
#include <fmt/format.h>

#include <cmath>

#include "brunt/scene/sections.hpp"
#include "brunt/scene/units.hpp"

namespace brunt::scene {
namespace {

constexpr Range of_matter{1, 25000, true, true, "kg/m^3"};  // aerogel, osmium
constexpr Range of_waves{10, 30000, true, true, "m/s"};     // soft foam; diamond has 18000
constexpr Range of_solids{100, 25000, true, true, "kg/m^3"};
constexpr Range of_common_waves{300, 15000, true, true, "m/s"};

double density_in_si(double density, const UnitSystem& units) {
  return density * units.kilogram / (units.metre * units.metre * units.metre);
}

double stress_in_si(double stress, const UnitSystem& units) {
  return stress * units.kilogram / (units.metre * units.second * units.second);
}

/// The first system in which the number would be the density of a solid; null if there is none.
const UnitSystem* better_for(double density) {
  for (const UnitSystem& other : unit_systems())
    if (other.metre > 0 && of_solids.holds(density_in_si(density, other))) return &other;
  return nullptr;
}

bool warn_of_density(Section& material, double density, const UnitSystem& units, Input& input) {
  const double in_si = density_in_si(density, units);
  if (of_matter.holds(in_si)) return false;
  std::string what = fmt::format("{}: {:g} {}", place_of(material.at("density")), density, units.density);
  if (units.name != "SI") what += fmt::format(" ({:.3g} kg/m^3)", in_si);
  what += fmt::format(" is no density of matter ({:g} to {:g} kg/m^3)", of_matter.low, of_matter.high);
  if (const UnitSystem* other = better_for(density))
    what += fmt::format("; in {}, of units {}, it would be {:.4g} kg/m^3", other->density, other->name,
                        density_in_si(density, *other));
  input.warnings.push_back(what);
  return true;
}

/// Speed of pressure waves in the unstrained solid, sqrt((lambda + 2 mu) / rho).
void warn_of_speed(Section& material, const material::Law& law, const UnitSystem& units, Input& input) {
  const material::ElasticModuli moduli = material::initial_moduli(law);
  const double stiffness = moduli.lambda + 2 * moduli.mu, density = density_in_si(moduli.density, units);
  const double speed = std::sqrt(stress_in_si(stiffness, units) / density);
  if (of_waves.holds(speed)) return;
  const char* modulus = material.has("young") ? "young" : "bulk";
  std::string what = fmt::format(
      "{}: with this stiffness and density waves run at {:.3g} m/s, as in no known matter (metals 1000 to 6000, rubber "
      "50 to 2000)",
      place_of(material.at(modulus)), speed);
  struct Unit {
    const char* name;
    double pascal;
  };
  for (const Unit unit : {Unit{"Pa", 1}, Unit{"MPa", 1e6}, Unit{"GPa", 1e9}, Unit{"kPa", 1e3}, Unit{"psi", 6894.757}}) {
    const double other = std::sqrt(stiffness * unit.pascal / density);
    if (unit.name == units.stress || !of_common_waves.holds(other)) continue;
    what += fmt::format("; stresses are in {} here: if {} is in {}, they run at {:.3g} m/s", units.stress, modulus,
                        unit.name, other);
    break;
  }
  input.warnings.push_back(what);
}

}  // namespace

void warn_of_units(Section& material, const material::Law& law, Input& input) {
  const UnitSystem* units = find_unit_system(input.units);
  const double density = std::visit([](const auto& some) { return some.density; }, law);
  if (units == nullptr || units->metre == 0 || !(density > 0)) return;
  if (warn_of_density(material, density, *units, input)) return;  // the speed would only say it again
  const material::ElasticModuli moduli = material::initial_moduli(law);
  if (moduli.lambda + 2 * moduli.mu > 0) warn_of_speed(material, law, *units, input);
}

}  // namespace brunt::scene
