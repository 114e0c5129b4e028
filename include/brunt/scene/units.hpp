// SPDX-License-Identifier: Apache-2.0
// The consistent unit systems a scene may name, and what each quantity is called in them. Nothing is converted: the
// names head the columns of results, the sizes serve plausibility checks.
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
/// Null if there is none of that name.
const UnitSystem* find_unit_system(std::string_view name);
/// "0.04 mm"; without a unit in the system `none` and where there is no such system.
std::string with_length(double length, std::string_view system, int digits = 4);

}  // namespace brunt::scene
