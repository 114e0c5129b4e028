// SPDX-License-Identifier: Apache-2.0
#include "read_metals.hpp"

#include <fmt/format.h>

namespace brunt::scene {
namespace {

using material::RateFactor;

const Choices<RateFactor::Form> rate_forms{
    {{"logarithm", RateFactor::Form::logarithm}, {"power", RateFactor::Form::power}}, {}};

/// Yield stresses of metals lie within these shares of Young's modulus: at least 1e-4 for lead and tin, 0.1 for
/// whiskers. Values outside are errors of units.
constexpr double least_yield = 1e-6, largest_yield = 0.2;

void check_yield(Section& material, const char* name, double yield, double young) {
  if (!(yield > 0) || !(young > 0) || (yield >= least_yield * young && yield <= largest_yield * young)) return;
  fault(material.at(name), fmt::format("out of range: the yield stress {:g} is {:.2g} of Young's modulus {:g}; "
                                       "expected {:g} to {:g} of it, both in the same units",
                                       yield, yield / young, young, least_yield, largest_yield));
}

double young_of(const material::Metal& law) {
  return law.bulk > 0 ? 9 * law.bulk * law.shear / (3 * law.bulk + law.shear) : 0;
}

/// density, young and poisson (with an equation of state also shear only, and the bulk modulus follows from it).
void read_moduli(Section& material, const Range& shear, material::Metal& law) {
  material.required("density", law.density, positive);
  if (material.has("eos")) read_eos(material, law);
  if (law.eos && material.has("shear")) {
    for (const char* name : {"young", "poisson"})
      if (material.has(name))
        fault(material.at(name), "invalid together with shear; expected young and poisson, or shear alone");
    material.required("shear", law.shear, shear);
  } else {
    double young = 0, poisson = 0;
    material.required("young", young, positive);
    material.required("poisson", poisson, poisson_ratio);
    law.shear = young / (2 * (1 + poisson));
    if (!law.eos) law.bulk = young / (3 * (1 - 2 * poisson));
  }
  if (!law.eos) return;
  const material::EquationOfState& eos = *law.eos;
  law.bulk =
      eos.model == material::EquationOfState::Model::mie_gruneisen ? law.density * eos.c * eos.c : eos.polynomial[1];
}

/// Keys of laws with temperature: heat_capacity, taylor_quinney, temperature (at the start; default `room`).
void read_heat(Section& material, double room, material::Heat& heat) {
  material.optional("heat_capacity", heat.capacity, positive);
  material.optional("taylor_quinney", heat.taylor_quinney, share);
  heat.start = room;
  material.optional("temperature", heat.start, any_number);
}

void read_rate_steps(Section& material, material::Metal& law) {
  constexpr Range steps{1, 10000, true, true, "a number from 1 to 10000"};
  material.optional("rate_steps", law.rate_steps, steps);
}

}  // namespace

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
  if (table.empty() && key.tree->kind == Tree::Kind::list && key.tree->children.empty()) wrong(key, expected);
}

material::Metal read_johnson_cook(Section& material) {
  material::Metal law;
  read_moduli(material, positive, law);
  material::JohnsonCook jc;
  material.required("A", jc.a, positive);
  check_yield(material, "A", jc.a, young_of(law));
  material.required("B", jc.b, not_negative);
  if (jc.b > largest_yield * young_of(law)) check_yield(material, "B", jc.b, young_of(law));
  material.required("n", jc.n, positive);
  law.rate.form = RateFactor::Form::logarithm;
  material.required("C", law.rate.c, not_negative);
  material.optional("rate", law.rate.reference, positive);
  material.optional("rate_form", law.rate.form, rate_forms);
  if (law.rate.c == 0) law.rate.form = RateFactor::Form::none;
  read_rate_steps(material, law);
  if (material.has("m") || material.has("melt") || material.has("room")) {
    material.required("m", jc.m, positive);
    const bool whole = material.required("melt", jc.melt, any_number);
    if (material.required("room", jc.room, any_number) && whole && jc.melt <= jc.room)
      fault(material.at("melt"),
            fmt::format("invalid melting temperature {:g}: not above room, {:g}; expected a higher temperature",
                        jc.melt, jc.room));
  }
  read_heat(material, jc.room, law.heat);
  law.strength = jc;
  read_damage(material, law);
  return law;
}

material::Metal read_piecewise_linear(Section& material) {
  material::Metal law;
  read_moduli(material, positive, law);
  material::TableStrength strength;
  if (material.has("hardening_table")) {
    for (const char* name : {"yield", "hardening"})
      if (material.has(name))
        fault(material.at(name),
              "invalid together with hardening_table; expected yield and hardening, or the table alone");
    read_hardening_table(material.at("hardening_table"), strength.table);
    if (!strength.table.empty()) check_yield(material, "hardening_table", strength.table[0][1], young_of(law));
  } else {
    double yield = 0, hardening = 0;
    material.required("yield", yield, positive);
    check_yield(material, "yield", yield, young_of(law));
    material.optional("hardening", hardening, not_negative);
    constexpr double far = 1000;  // of plastic strain: beyond any physical value
    strength.table = {{0, yield}, {far, yield + far * hardening}};
  }
  if (material.has("cowper_symonds")) {
    Section rate(material.at("cowper_symonds"), "a map {rate: number, exponent: number}");
    double exponent = 1;
    law.rate.form = RateFactor::Form::cowper_symonds;
    rate.required("rate", law.rate.reference, positive);
    rate.required("exponent", exponent, positive);
    law.rate.c = 1 / exponent;
  }
  read_rate_steps(material, law);
  read_heat(material, 0, law.heat);
  if (strength.table.empty()) strength.table = {{0, 1}};  // a fault has been reported
  law.strength = strength;
  read_damage(material, law);
  return law;
}

material::Metal read_hydrodynamic(Section& material) {
  material::Metal law;
  if (!material.has("eos")) lacking(material.key(), {"eos"}, "missing equation of state; expected eos: {model: ...}");
  read_moduli(material, not_negative, law);  // without shear: a fluid
  material::LinearStrength strength;
  material.required("yield", strength.yield, not_negative);
  check_yield(material, "yield", strength.yield, young_of(law));
  material.optional("hardening", strength.hardening, not_negative);
  material.optional("pressure_yield", strength.pressure_yield, not_negative);
  read_rate_steps(material, law);
  read_heat(material, 0, law.heat);
  law.strength = strength;
  read_damage(material, law);
  return law;
}

material::Foam read_foam(Section& material) {
  material::Foam law;
  material.required("density", law.density, positive);
  material.required("young", law.young, positive);
  constexpr std::string_view expected = "a list of [volumetric strain in compression, yield stress], the first at 0";
  if (material.has("yield_table")) {
    read_hardening_table(material.at("yield_table"), law.table);
    for (const auto& [lost, yield] : law.table)
      if (lost >= 1)
        fault(material.at("yield_table"), "out of range: a volumetric strain of 1 or more; expected values below 1");
    if (!law.table.empty()) check_yield(material, "yield_table", law.table[0][1], law.young);
  } else {
    lacking(material.key(), {"yield_table"}, fmt::format("missing yield_table; expected {}", expected));
  }
  if (law.table.empty()) law.table = {{0, 1}};  // a fault has been reported
  law.tension = law.table.front()[1];
  material.optional("tension", law.tension, not_negative);
  return law;
}

void read_damage(Section& material, material::Metal& law) {
  if (!material.has("damage")) return;
  Section section(material.at("damage"), "a map {D1: number, D2: number, D3: number, D4: number, D5: number}");
  material::Fracture fracture;
  section.required("D1", fracture.d1, any_number);
  section.required("D2", fracture.d2, not_negative);
  section.required("D3", fracture.d3, any_number);
  section.optional("D4", fracture.rate.c, any_number);
  section.optional("D5", fracture.d5, any_number);
  if (fracture.d5 <= -1)
    fault(section.at("D5"), fmt::format("out of range: {:g} makes the strain at fracture negative below the melting "
                                        "temperature; expected a number > -1",
                                        fracture.d5));
  if (section.is_map() && fracture.d1 + fracture.d2 <= 0)
    fault(section.key(),
          fmt::format("out of range: D1 + D2 = {:g} makes the strain at fracture negative in shear; expected a sum > 0",
                      fracture.d1 + fracture.d2));
  if (fracture.d3 > 0)
    fault(section.at("D3"),
          "out of range: a positive value would increase ductility in tension; expected a number <= 0");
  fracture.rate.form = law.rate.form == RateFactor::Form::power ? law.rate.form : RateFactor::Form::logarithm;
  fracture.rate.reference = law.rate.form == RateFactor::Form::cowper_symonds ? 1.0 : law.rate.reference;
  section.optional("rate", fracture.rate.reference, positive);
  section.optional("rate_form", fracture.rate.form, rate_forms);
  if (fracture.rate.c == 0) fracture.rate.form = RateFactor::Form::none;
  constexpr Range to_one{0, 1, false, true, "a number > 0 and <= 1"};
  section.optional("critical", fracture.critical, to_one);
  section.optional("softens", fracture.softens);
  law.fracture = fracture;
}

void read_eos(Section& material, material::Metal& law) {
  using Model = material::EquationOfState::Model;
  static const Choices<Model> models{
      {{"mie_gruneisen", Model::mie_gruneisen}, {"linear_polynomial", Model::linear_polynomial}}, {}};
  Section section(material.at("eos"), "a map {model: mie_gruneisen or linear_polynomial, ...}");
  material::EquationOfState eos;
  section.required("model", eos.model, models);
  if (eos.model == Model::mie_gruneisen) {
    section.required("c", eos.c, positive);
    section.required("s", eos.s, not_negative);
    section.required("gamma", eos.gamma, not_negative);
  } else {
    constexpr std::array<const char*, 7> names{"C0", "C1", "C2", "C3", "C4", "C5", "C6"};
    for (std::size_t k = 0; k < names.size(); ++k)
      if (k == 1)
        section.required(names[k], eos.polynomial[k], positive);
      else
        section.optional(names[k], eos.polynomial[k], any_number);
  }
  section.optional("energy", eos.start_energy, any_number);
  constexpr Range not_positive{-infinity, 0, false, true, "a number <= 0"};
  section.optional("minimum_pressure", eos.minimum_pressure, not_positive);
  law.eos = eos;
}

}  // namespace brunt::scene
