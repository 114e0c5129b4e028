// SPDX-License-Identifier: Apache-2.0
// Materials by model.
#include "given_material.hpp"
#include "scene/read/sections.hpp"
#include "scene/rules/rules.hpp"

namespace brunt::scene {
namespace {

using Given = GivenMaterial;

const Choices<Model> models{{{"elastic", Model::elastic},
                             {"j2", Model::j2},
                             {"neo_hookean", Model::neo_hookean},
                             {"johnson_cook", Model::johnson_cook},
                             {"piecewise_linear", Model::piecewise_linear},
                             {"hydrodynamic", Model::hydrodynamic},
                             {"crushable_foam", Model::crushable_foam},
                             {"rigid", Model::rigid}},
                            {}};
const Choices<material::StressRate> stress_rates{
    {{"jaumann", material::StressRate::jaumann}, {"logarithmic", material::StressRate::logarithmic}}, {}};
constexpr Range steps_of_rate{1, 10000, true, true, "a number from 1 to 10000"};

const Table<CowperSymonds> cowper_symonds_keys{
    "materials.cowper_symonds",
    "a map {rate: number, exponent: number}",
    {
        {"rate", value(&CowperSymonds::rate, positive), "1/time",
         "The yield stress is multiplied by 1 + (r/rate)^(1/exponent), r the strain rate.", required},
        {"exponent", value(&CowperSymonds::exponent, positive), "-", "See `rate`.", required},
    },
};

void read_table(const Key& key, Given& given) {
  read_hardening_table(key, given.table);
}

/// Yield stress over volumetric strain.
void read_yield_table(const Key& key, Given& given) {
  if (key.tree == nullptr) {
    wrong(key, "a list of [volumetric strain in compression, yield stress], the first at 0");
    return;
  }
  read_hardening_table(key, given.table);
  for (const auto& [lost, yield] : given.table)
    if (lost >= 1) fault(key, "out of range: a volumetric strain of 1 or more; expected values below 1");
}

material::J2 judged_j2(const Key& map, const Given& given) {
  judge_hardening(map);
  return {.density = given.density,
          .young = given.young,
          .poisson = given.poisson,
          .yield = given.table.empty() ? given.yield : given.table.front()[1],
          .hardening = given.hardening,
          .table = given.table,
          .kinematic = given.kinematic,
          .stress_rate = given.stress_rate};
}

/// lambda = K - 2/3 G, or lambda = E nu / ((1 + nu)(1 - 2 nu)), mu = G = E / (2 (1 + nu)).
material::NeoHookean judged_neo_hookean(const Key& map, const Given& given) {
  const bool by_bulk = has(map, "bulk") || has(map, "shear"), by_young = has(map, "young") || has(map, "poisson");
  const double young = given.young, poisson = given.poisson;
  if (by_bulk && by_young)
    fault(map, "invalid constants: both pairs are given; expected young and poisson, or bulk and shear");
  for (const char* name : {"bulk", "shear"})
    if (by_bulk && !by_young) demand(map, name, positive.words);
  if (by_bulk) return {given.density, given.bulk - 2.0 / 3.0 * given.shear, given.shear};
  demand(map, "young", positive.words);
  demand(map, "poisson", poisson_ratio.words);
  return {given.density, young * poisson / ((1 + poisson) * (1 - 2 * poisson)), young / (2 * (1 + poisson))};
}

material::Foam judged_foam(const Key& map, const Given& given) {
  const double first = given.table.empty() ? 0 : given.table.front()[1];
  judge_yield(map, "yield_table", first, given.young);
  return {given.density, given.young, given.table, given.tension.value_or(first)};
}

void judge_material(const Key& map, Given& given) {
  if (!given.model) return;
  switch (*given.model) {
    case Model::elastic:
      given.law = material::Elastic{given.density, given.young, given.poisson, given.stress_rate};
      break;
    case Model::j2:
      given.law = judged_j2(map, given);
      break;
    case Model::neo_hookean:
      given.law = judged_neo_hookean(map, given);
      break;
    case Model::johnson_cook:
      given.law = judged_johnson_cook(map, given);
      break;
    case Model::piecewise_linear:
      given.law = judged_piecewise_linear(map, given);
      break;
    case Model::hydrodynamic:
      given.law = judged_hydrodynamic(map, given);
      break;
    case Model::crushable_foam:
      given.law = judged_foam(map, given);
      break;
    case Model::rigid:
      given.law = material::Rigid{given.density};
      break;
  }
}

std::string_view model_of(const Given& given) {
  for (const auto& [word, model] : models.now)
    if (given.model == model) return word;
  return "";
}

std::vector<Row<Given>> elastic_rows() {
  return {
      {"model", value(&Given::model, models), "-", "The constitutive law.", required},
      {"density", value(&Given::density, positive), "mass/length^3", "Density in the initial state.", required},
      {"young", of("elastic", "j2", "crushable_foam"), value(&Given::young, positive), "stress", "Young's modulus.",
       required},
      {"young", of("neo_hookean", "johnson_cook", "piecewise_linear", "hydrodynamic"), value(&Given::young, positive),
       "stress", "Young's modulus.", "required, or `shear`"},
      {"poisson", of("elastic", "j2"), value(&Given::poisson, poisson_ratio), "-", "Poisson's ratio.", required},
      {"poisson", of("neo_hookean", "johnson_cook", "piecewise_linear", "hydrodynamic"),
       value(&Given::poisson, poisson_ratio), "-", "Poisson's ratio.", "required, or `shear`"},
      {"bulk", of("neo_hookean"), value(&Given::bulk, positive), "stress",
       "Bulk modulus, with `shear` in place of `young` and `poisson`.", "none"},
      {"shear", of("neo_hookean"), value(&Given::shear, positive), "stress", "Shear modulus.", "required with `bulk`"},
      {"shear", of("johnson_cook", "piecewise_linear"), value(&Given::shear, positive), "stress",
       "Shear modulus, with `eos` in place of `young` and `poisson`.", "none"},
      {"shear", of("hydrodynamic"), value(&Given::shear, not_negative), "stress", "The same; 0 is a fluid.", "none"},
      {"stress_rate", of("elastic", "j2"), value(&Given::stress_rate, stress_rates), "-",
       "[Objective stress rate](../material/README.md#stress-rates); it matters in large elastic strains."},
  };
}

std::vector<Row<Given>> plastic_rows() {
  return {
      {"yield", of("j2", "piecewise_linear"), value(&Given::yield, positive), "stress", "Initial yield stress.",
       "required, or `hardening_table`"},
      {"yield", of("hydrodynamic"), value(&Given::yield, not_negative), "stress", "Initial yield stress.", required},
      {"hardening", of("j2", "piecewise_linear", "hydrodynamic"), value(&Given::hardening, not_negative), "stress",
       "Increase of the yield stress with the plastic strain."},
      {"hardening_table", of("j2", "piecewise_linear"), special("list of `[plastic strain, yield stress]`", read_table),
       "-, stress",
       "Replaces `yield` and `hardening`: strains from 0 and increasing, stresses not decreasing, constant beyond."},
      {"kinematic", of("j2"), value(&Given::kinematic, share), "-", "Share of the hardening that is kinematic."},
      {"A", of("johnson_cook"), value(&Given::a, positive), "stress", "Initial yield stress.", required},
      {"B", of("johnson_cook"), value(&Given::b, not_negative), "stress", "Hardening coefficient.", required},
      {"n", of("johnson_cook"), value(&Given::n, positive), "-", "Hardening exponent.", required},
      {"C", of("johnson_cook"), value(&Given::c, not_negative), "-", "Coefficient of the strain rate.", required},
      {"rate", of("johnson_cook"), value(&Given::rate, positive), "1/time",
       "Reference strain rate of `C`. Published constants refer to 1/s, which is 1e-3 per millisecond."},
      {"rate_form", of("johnson_cook"), value(&Given::rate_form, rate_forms()), "-",
       "Factor 1 + C ln(r/rate), or (1 + r/rate)^C."},
      {"m", of("johnson_cook"), value(&Given::m, positive), "-",
       "Exponent of thermal softening; needs `melt` and `room`."},
      {"melt", of("johnson_cook"), value(&Given::melt, any_number), "temperature",
       "Melting temperature, above `room`."},
      {"room", of("johnson_cook"), value(&Given::room, any_number), "temperature",
       "Temperature at which thermal softening begins."},
      {"cowper_symonds", of("piecewise_linear"), map_of(&Given::cowper_symonds, cowper_symonds_keys), "-",
       "Rate law of Cowper and Symonds."},
      {"pressure_yield", of("hydrodynamic"), value(&Given::pressure_yield, not_negative), "-",
       "Increase of the yield stress with the pressure."},
      {"rate_steps", of("johnson_cook", "piecewise_linear", "hydrodynamic"), value(&Given::rate_steps, steps_of_rate),
       "-", "Number of steps over which the strain rate is averaged."},
  };
}

std::vector<Row<Given>> other_rows() {
  return {
      {"heat_capacity", of("johnson_cook", "piecewise_linear", "hydrodynamic"), value(&Given::heat_capacity, positive),
       "energy/(mass temperature)", "Specific heat; without it plastic work does not raise the temperature.", "none"},
      {"taylor_quinney", of("johnson_cook", "piecewise_linear", "hydrodynamic"), value(&Given::taylor_quinney, share),
       "-", "Share of the plastic work that becomes heat."},
      {"temperature", of("johnson_cook"), value(&Given::temperature, any_number), "temperature", "Initial temperature.",
       "`room`"},
      {"temperature", of("piecewise_linear", "hydrodynamic"), value(&Given::temperature, any_number), "temperature",
       "Initial temperature.", shown(material::Heat{}.start)},
      {"damage", of("johnson_cook", "piecewise_linear", "hydrodynamic"), map_of(&Given::damage, damage_keys), "-",
       "Damage law of Johnson and Cook."},
      {"eos", of("johnson_cook", "piecewise_linear"), map_of(&Given::eos, eos_keys), "-",
       "Equation of state in place of the elastic pressure."},
      {"eos", of("hydrodynamic"), map_of(&Given::eos, eos_keys), "-", "Equation of state.", required},
      {"yield_table", of("crushable_foam"), special("list of `[volumetric strain, yield stress]`", read_yield_table),
       "-, stress", "Yield stress of each principal stress against the volumetric strain in compression.", required},
      {"tension", of("crushable_foam"), value(&Given::tension, not_negative), "stress", "Tensile strength.",
       "first yield stress"},
  };
}

const Table<Given> material_keys{
    "materials",
    "a map {model: elastic, j2, neo_hookean, johnson_cook ... or rigid, density: ...}",
    joined(joined(elastic_rows(), plastic_rows()), other_rows()),
    judge_material,
    model_of,
};

/// `units` has been read.
void read_material_map(const Key& map, Input& input) {
  for (const auto& [name, key] : entries(map, "a map of names, each {model: ..., density: ...}")) {
    Given given;
    if (material_keys.read(key, given)) warn_of_units(key, given.law, input.units);
    input.materials[name] = given.law;
  }
}

}  // namespace

Value<Input> materials_value() {
  return special("map", read_material_map, {&material_keys});
}

}  // namespace brunt::scene
