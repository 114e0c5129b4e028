// SPDX-License-Identifier: Apache-2.0
// Plausibility of material constants in the units of the scene: wrong units are the most common error in scenes that
// run.
#include <fmt/format.h>

#include <array>
#include <cmath>

#include "scene/rules/rules.hpp"
#include "scene/text/units.hpp"

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

/// in-s-lbf and ft-s-lbf.
bool is_american(const UnitSystem& units) {
  return units.force == "lbf";
}

/// The first system, American or not, in which the number would be the density of a solid.
std::string better_system(double density, bool american) {
  for (const UnitSystem& other : unit_systems())
    if (other.metre > 0 && is_american(other) == american && of_solids.holds(density_in_si(density, other)))
      return fmt::format("; read in {}, of units {}, it would be {:.4g} kg/m^3", other.density, other.name,
                         density_in_si(density, other));
  return {};
}

/// American tables list weights: 0.283 lbf/in^3 of steel is 7.33e-4 lbf.s^2/in^4. Empty if the number is no such
/// weight.
std::string as_weight(double density, const UnitSystem& units) {
  constexpr double standard_gravity = 9.80665;  // m/s^2
  if (!is_american(units)) return {};
  const double gravity = standard_gravity * units.second * units.second / units.metre;
  const double mass = density / gravity, in_si = density_in_si(mass, units);
  if (!of_solids.holds(in_si)) return {};
  return fmt::format("; a weight of {:g} lbf/{}^3 is a density of {:.4g} {} (divide by {:.2f} {}/{}^2), {:.4g} kg/m^3",
                     density, units.length, mass, units.density, gravity, units.length, units.time, in_si);
}

bool warn_of_density(const Key& material, double density, const UnitSystem& units) {
  const double in_si = density_in_si(density, units);
  if (of_matter.holds(in_si)) return false;
  std::string what = fmt::format("{:g} {}", density, units.density);
  if (units.name != "SI") what += fmt::format(" ({:.3g} kg/m^3)", in_si);
  what += fmt::format(" is outside the densities of known matter, {:g} to {:g} kg/m^3", of_matter.low, of_matter.high);
  const std::string weight = as_weight(density, units);
  const std::string other = better_system(density, false);
  const std::string american = is_american(units) || other.empty() ? better_system(density, true) : "";
  what += weight.empty() ? american + other : weight;
  warn(at(material, "density"), what);
  return true;
}

struct StressUnit {
  const char* name;
  double pascal;
};
constexpr double psi = 6894.757;
constexpr std::array<StressUnit, 8> stress_units{{{"Pa", 1},
                                                  {"MPa", 1e6},
                                                  {"GPa", 1e9},
                                                  {"kPa", 1e3},
                                                  {"psi", psi},
                                                  {"ksi", 1e3 * psi},
                                                  {"Msi", 1e6 * psi},
                                                  {"psf", psi / 144}}};

/// The first unit that gives a usual wave speed. Of the American units psi, ksi and Msi may all do so; the result is
/// the one nearest to metals. Empty if there is none.
std::string better_unit(double stiffness, double density, const UnitSystem& units, const char* modulus) {
  constexpr double of_metals = 4000;  // m/s
  const StressUnit* best = nullptr;
  double best_speed = 0;
  for (const StressUnit& unit : stress_units) {
    const double speed = std::sqrt(stiffness * unit.pascal / density);
    if (unit.name == units.stress || !of_common_waves.holds(speed)) continue;
    const bool nearer = std::abs(std::log(speed / of_metals)) < std::abs(std::log(best_speed / of_metals));
    if (best != nullptr && !(is_american(units) && nearer)) continue;
    best = &unit;
    best_speed = speed;
  }
  if (best == nullptr) return {};
  return fmt::format("; stresses are in {} here: with {} in {} the wave speed is {:.3g} m/s", units.stress, modulus,
                     best->name, best_speed);
}

/// Slow waves occur in soft and light matter: 29000 ksi of steel read as psi give 180 m/s. For American units only,
/// where ksi and psi are easily confused.
bool is_heavy_and_soft(double speed, double density, const UnitSystem& units) {
  constexpr double heavy = 2500, slow = 300;  // kg/m^3, m/s
  return is_american(units) && density > heavy && speed < slow;
}

/// Speed of pressure waves in the unstrained solid, sqrt((lambda + 2 mu) / rho).
void warn_of_speed(const Key& material, const material::Law& law, const UnitSystem& units) {
  const material::ElasticModuli moduli = material::initial_moduli(law);
  const double stiffness = moduli.lambda + 2 * moduli.mu, density = density_in_si(moduli.density, units);
  const double speed = std::sqrt(stress_in_si(stiffness, units) / density);
  if (of_waves.holds(speed) && !is_heavy_and_soft(speed, density, units)) return;
  const char* modulus = has(material, "young") ? "young" : "bulk";
  std::string what = fmt::format(
      "this stiffness and density give a wave speed of {:.3g} m/s, outside that of known matter (metals 1000 to 6000, "
      "rubber 50 to 2000)",
      speed);
  what += better_unit(stiffness, density, units, modulus);
  warn(at(material, modulus), what);
}

}  // namespace

void warn_of_units(const Key& material, const material::Law& law, const std::string& unit_system) {
  const UnitSystem* units = find_unit_system(unit_system);
  const double density = std::visit([](const auto& some) { return some.density; }, law);
  if (units == nullptr || units->metre == 0 || !(density > 0)) return;
  if (warn_of_density(material, density, *units)) return;  // a warning of the speed would repeat it
  const material::ElasticModuli moduli = material::initial_moduli(law);
  if (moduli.lambda + 2 * moduli.mu > 0) warn_of_speed(material, law, *units);
}

}  // namespace brunt::scene
