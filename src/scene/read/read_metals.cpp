// SPDX-License-Identifier: Apache-2.0
// Laws of metals under impact, from the constants that a scene gives.
#include <fmt/format.h>

#include "given_material.hpp"

namespace brunt::scene {
namespace {

/// Yield stresses of metals lie within these shares of Young's modulus: at least 1e-4 for lead and tin, 0.1 for
/// whiskers. Values outside are errors of units.
constexpr double least_yield = 1e-6, largest_yield = 0.2;

double young_of(const material::Metal& law) {
  return law.bulk > 0 ? 9 * law.bulk * law.shear / (3 * law.bulk + law.shear) : 0;
}

/// The shear modulus from young and poisson, or with an equation of state also given alone; the bulk modulus then
/// follows from the equation.
void judge_moduli(const Key& map, const GivenMaterial& given, material::Metal& law) {
  if (!given.eos) refuse_any(map, {"shear"}, "invalid without eos; expected young and poisson");
  if (given.eos && has(map, "shear")) {
    refuse_any(map, {"young", "poisson"}, "invalid together with shear; expected young and poisson, or shear alone");
    law.shear = given.shear;
  } else {
    demand(map, "young", positive.words);
    demand(map, "poisson", poisson_ratio.words);
    law.shear = given.young / (2 * (1 + given.poisson));
    law.bulk = given.young / (3 * (1 - 2 * given.poisson));
  }
  if (!given.eos) return;
  const material::EquationOfState& eos = *given.eos;
  law.bulk =
      eos.model == material::EquationOfState::Model::mie_gruneisen ? given.density * eos.c * eos.c : eos.polynomial[1];
}

/// What all metals have. room: the temperature at the start, if none is given.
material::Metal judged_metal(const Key& map, const GivenMaterial& given, double room) {
  material::Metal law;
  law.density = given.density;
  law.eos = given.eos;
  judge_moduli(map, given, law);
  law.rate_steps = given.rate_steps;
  law.heat = {given.heat_capacity, given.taylor_quinney, given.temperature.value_or(room)};
  return law;
}

/// Damage has the rate factor of the strength, unless it has its own.
std::optional<material::Fracture> fracture_of(const GivenMaterial& given, const material::RateFactor& strength) {
  if (!given.damage) return {};
  const GivenDamage& damage = *given.damage;
  const double reference = strength.form == Form::cowper_symonds ? 1.0 : strength.reference;
  const Form form = damage.rate_form.value_or(strength.form == Form::power ? Form::power : Form::logarithm);
  material::Fracture fracture{damage.d1, damage.d2, damage.d3, damage.d5, {}, damage.critical, damage.softens};
  fracture.rate = {damage.d4 == 0 ? Form::none : form, damage.d4, damage.rate.value_or(reference)};
  return fracture;
}

/// Thermal softening has three constants, or none.
void judge_softening(const Key& map, const GivenMaterial& given) {
  if (!has(map, "m") && !has(map, "melt") && !has(map, "room")) return;
  demand(map, "m", positive.words);
  demand(map, "melt", any_number.words);
  demand(map, "room", any_number.words);
  if (given.melt && given.room && *given.melt <= *given.room)
    fault(at(map, "melt"),
          fmt::format("invalid melting temperature {:g}: not above room, {:g}; expected a higher temperature",
                      *given.melt, *given.room));
}

}  // namespace

const Choices<Form>& rate_forms() {
  static const Choices<Form> forms{{{"logarithm", Form::logarithm}, {"power", Form::power}}, {}};
  return forms;
}

void judge_yield(const Key& map, const char* name, double yield, double young) {
  if (!(yield > 0) || !(young > 0) || (yield >= least_yield * young && yield <= largest_yield * young)) return;
  fault(at(map, name), fmt::format("out of range: the yield stress {:g} is {:.2g} of Young's modulus {:g}; expected "
                                   "{:g} to {:g} of it, both in the same units",
                                   yield, yield / young, young, least_yield, largest_yield));
}

void judge_hardening(const Key& map) {
  if (has(map, "hardening_table"))
    refuse_any(map, {"yield", "hardening"},
               "invalid together with hardening_table; expected yield and hardening, or the table alone");
  else
    demand(map, "yield", positive.words);
}

void read_hardening_table(const Key& key, std::vector<std::array<double, 2>>& table) {
  constexpr std::string_view expected = "a list of [plastic strain, yield stress], the first at strain 0";
  for (const Key& row : items(key, expected)) {
    std::array<double, 2> point{};
    if (!read(row, point, not_negative, "[plastic strain, yield stress]")) return;
    const bool first = table.empty();
    if (first && point[0] != 0) return fault(row, "invalid plastic strain of the first point; expected 0");
    if (point[1] <= 0) return fault(row, "out of range: the yield stress is not positive; expected a number > 0");
    if (!first && point[0] <= table.back()[0]) {
      return fault(row, "invalid plastic strain: it does not increase; expected strictly increasing strains");
    }
    if (!first && point[1] < table.back()[1]) {
      return fault(row, "invalid yield stress: it decreases (softening); expected stresses that do not decrease");
    }
    table.push_back(point);
  }
  if (table.empty() && is_list(key) && key.tree->children.empty()) wrong(key, expected);
}

material::Metal judged_johnson_cook(const Key& map, const GivenMaterial& given) {
  judge_softening(map, given);
  material::JohnsonCook jc{.a = given.a, .b = given.b, .n = given.n};
  if (given.m) jc.m = *given.m;
  jc.room = given.room.value_or(jc.room);
  jc.melt = given.melt.value_or(jc.melt);
  material::Metal law = judged_metal(map, given, jc.room);
  judge_yield(map, "A", jc.a, young_of(law));
  if (jc.b > largest_yield * young_of(law)) judge_yield(map, "B", jc.b, young_of(law));
  law.rate = {given.c == 0 ? Form::none : given.rate_form, given.c, given.rate};
  law.strength = jc;
  law.fracture = fracture_of(given, law.rate);
  return law;
}

material::Metal judged_piecewise_linear(const Key& map, const GivenMaterial& given) {
  judge_hardening(map);
  material::Metal law = judged_metal(map, given, material::Heat{}.start);
  material::TableStrength strength{given.table};
  if (!has(map, "hardening_table")) {
    judge_yield(map, "yield", given.yield, young_of(law));
    constexpr double far = 1000;  // of plastic strain: beyond any physical value
    strength.table = {{0, given.yield}, {far, given.yield + far * given.hardening}};
  } else if (!strength.table.empty()) {
    judge_yield(map, "hardening_table", strength.table[0][1], young_of(law));
  }
  if (given.cowper_symonds)
    law.rate = {Form::cowper_symonds, 1 / given.cowper_symonds->exponent, given.cowper_symonds->rate};
  law.strength = strength;
  law.fracture = fracture_of(given, law.rate);
  return law;
}

material::Metal judged_hydrodynamic(const Key& map, const GivenMaterial& given) {
  material::Metal law = judged_metal(map, given, material::Heat{}.start);
  judge_yield(map, "yield", given.yield, young_of(law));
  law.strength = material::LinearStrength{given.yield, given.hardening, given.pressure_yield};
  law.fracture = fracture_of(given, law.rate);
  return law;
}

}  // namespace brunt::scene
