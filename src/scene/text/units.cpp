// SPDX-License-Identifier: Apache-2.0
#include "scene/text/units.hpp"

#include <fmt/format.h>

#include <array>

namespace brunt::scene {
namespace {

constexpr double inch = 0.0254, foot = 0.3048;   // exact since 1959
constexpr double pound_force = 4.4482216152605;  // 0.45359237 kg at 9.80665 m/s^2: exact
constexpr double slinch = pound_force / inch,
                 slug = pound_force / foot;  // 1 lbf accelerates them by 1 in/s^2, 1 ft/s^2

// clang-format off
const std::array<UnitSystem, 10> systems{{
    {"SI", "m", "s", "kg", "N", "J", "Pa", "m/s", "N.s", "kg/m^3", 1, 1, 1},
    {"mm-ms-kg", "mm", "ms", "kg", "kN", "J", "GPa", "mm/ms", "N.s", "kg/mm^3", 1e-3, 1e-3, 1},
    {"mm-ms-g", "mm", "ms", "g", "N", "mJ", "MPa", "mm/ms", "N.ms", "g/mm^3", 1e-3, 1e-3, 1e-3},
    {"mm-s-tonne", "mm", "s", "t", "N", "mJ", "MPa", "mm/s", "N.s", "t/mm^3", 1e-3, 1, 1e3},
    {"mm-us-g", "mm", "us", "g", "MN", "kJ", "TPa", "mm/us", "N.s", "g/mm^3", 1e-3, 1e-6, 1e-3},
    {"cm-us-g", "cm", "us", "g", "1e7 N", "1e5 J", "Mbar", "cm/us", "g.cm/us", "g/cm^3", 1e-2, 1e-6, 1e-3},
    {"cm-s-g", "cm", "s", "g", "dyn", "erg", "dyn/cm^2", "cm/s", "dyn.s", "g/cm^3", 1e-2, 1, 1e-3},
    {"in-s-lbf", "in", "s", "lbf.s^2/in", "lbf", "in.lbf", "psi", "in/s", "lbf.s", "lbf.s^2/in^4", inch, 1, slinch},
    {"ft-s-lbf", "ft", "s", "slug", "lbf", "ft.lbf", "psf", "ft/s", "lbf.s", "slug/ft^3", foot, 1, slug},
    {"none", "1", "1", "1", "1", "1", "1", "1", "1", "1", 0, 0, 0},
}};
// clang-format on

}  // namespace

std::span<const UnitSystem> unit_systems() {
  return systems;
}

const UnitSystem* find_unit_system(std::string_view name) {
  for (const UnitSystem& system : systems) {
    if (system.name == name) return &system;
  }
  return nullptr;
}

std::string with_length(double length, std::string_view system, int digits) {
  const UnitSystem* units = find_unit_system(system);
  const bool has_unit = units != nullptr && units->metre > 0;
  return fmt::format("{:.{}g}{}{}", length, digits, has_unit ? " " : "", has_unit ? units->length : "");
}

}  // namespace brunt::scene
