// SPDX-License-Identifier: Apache-2.0
// The consistent unit systems that a scene may name, and the names of their units. Nothing is converted: the names
// appear in the headers of results, and the sizes serve plausibility checks.
#pragma once
#include <span>
#include <string>
#include <string_view>

namespace brunt::scene {

struct UnitSystem {
  std::string name;  ///< as in `units:`
  std::string length, time, mass, force, energy, stress, velocity, momentum, density;
  double metre, second, kilogram;  ///< length, time and mass unit in SI; 0 for `none`
};

std::span<const UnitSystem> unit_systems();
/// Null if there is no system of that name.
const UnitSystem* find_unit_system(std::string_view name);
/// "0.04 mm"; without a unit in the system `none`, and for an unknown system.
std::string with_length(double length, std::string_view system, int digits = 4);

}  // namespace brunt::scene
