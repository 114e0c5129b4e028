// SPDX-License-Identifier: Apache-2.0
// A material as a scene gives it, of any model: what the readers of its keys and the judges of its law share.
#pragma once
#include <array>
#include <optional>
#include <vector>

#include "material/law.hpp"
#include "scene/keys/table.hpp"

namespace brunt::scene {

enum class Model { elastic, j2, neo_hookean, johnson_cook, piecewise_linear, hydrodynamic, crushable_foam, rigid };

struct CowperSymonds {
  double rate = 1;  ///< [1/time]
  double exponent = 1;
};

/// The map `damage`; without values: as of the material.
struct GivenDamage {
  double d1 = 0, d2 = 0, d3 = 0, d4 = material::RateFactor{}.c, d5 = material::Fracture{}.d5;
  std::optional<double> rate;  ///< [1/time]
  std::optional<material::RateFactor::Form> rate_form;
  double critical = material::Fracture{}.critical;
  bool softens = material::Fracture{}.softens;
};

/// Constants without a default are 0, or have no value, if they are missing.
struct GivenMaterial {
  std::optional<Model> model;
  double density = 0;                                  ///< [mass/length^3]
  double young = 0, poisson = 0, bulk = 0, shear = 0;  ///< [stress]
  material::StressRate stress_rate = material::Elastic{}.stress_rate;
  double yield = 0, hardening = material::J2{}.hardening;  ///< [stress]
  double kinematic = material::J2{}.kinematic;
  std::vector<std::array<double, 2>> table;        ///< (strain, yield stress): `hardening_table` or `yield_table`
  double a = 0, b = 0, n = 1, c = 0;               ///< of Johnson and Cook
  double rate = material::RateFactor{}.reference;  ///< [1/time]
  material::RateFactor::Form rate_form = material::RateFactor::Form::logarithm;
  std::optional<double> m, melt, room;  ///< [-], [temperature]
  std::optional<CowperSymonds> cowper_symonds;
  double pressure_yield = material::LinearStrength{}.pressure_yield;
  double rate_steps = material::Metal{}.rate_steps;
  double heat_capacity = material::Heat{}.capacity, taylor_quinney = material::Heat{}.taylor_quinney;
  std::optional<double> temperature;
  std::optional<GivenDamage> damage;
  std::optional<material::EquationOfState> eos;
  std::optional<double> tension;  ///< [stress]

  material::Law law{};  ///< the result
};

using Form = material::RateFactor::Form;
const Choices<Form>& rate_forms();

extern const Table<GivenDamage> damage_keys;
extern const Table<material::EquationOfState> eos_keys;

/// Yield stress over plastic strain; softening is a fault.
void read_hardening_table(const Key& key, std::vector<std::array<double, 2>>& table);

/// Adds a fault if a yield stress is no plausible share of Young's modulus.
void judge_yield(const Key& map, const char* name, double yield, double young);
/// Judges yield and hardening, or the table that replaces them.
void judge_hardening(const Key& map);

/// Laws of these models, judged. map: of the material.
material::Metal judged_johnson_cook(const Key& map, const GivenMaterial& given);
material::Metal judged_piecewise_linear(const Key& map, const GivenMaterial& given);
material::Metal judged_hydrodynamic(const Key& map, const GivenMaterial& given);

}  // namespace brunt::scene
