// SPDX-License-Identifier: Apache-2.0
// Damage and equations of state of metals.
#include <fmt/format.h>

#include "given_material.hpp"

namespace brunt::scene {
namespace {

using material::EquationOfState;
using EosModel = EquationOfState::Model;

constexpr Range not_positive{-infinity, 0, false, true, "a number <= 0"};
const Choices<EosModel> eos_models{
    {{"mie_gruneisen", EosModel::mie_gruneisen}, {"linear_polynomial", EosModel::linear_polynomial}}, {}};

std::string_view name_of_model(const EquationOfState& eos) {
  return eos_models.now[eos.model == EosModel::mie_gruneisen ? 0 : 1].first;
}

/// C0 to C6.
Value<EquationOfState> coefficient(std::size_t k, const Range& range = any_number) {
  return {.type = phrase(0.0, range),
          .read = [=](const Key& key, EquationOfState& eos) { read(key, eos.polynomial[k], range); },
          .shown = [=](const EquationOfState& eos) { return shown(eos.polynomial[k]); }};
}

void judge_damage(const Key& map, GivenDamage& damage) {
  if (damage.d5 <= -1)
    fault(at(map, "D5"), fmt::format("out of range: {:g} makes the strain at fracture negative below the melting "
                                     "temperature; expected a number > -1",
                                     damage.d5));
  if (damage.d1 + damage.d2 <= 0)
    fault(map,
          fmt::format("out of range: D1 + D2 = {:g} makes the strain at fracture negative in shear; expected a sum > 0",
                      damage.d1 + damage.d2));
  if (damage.d3 > 0)
    fault(at(map, "D3"), "out of range: a positive value would increase ductility in tension; expected a number <= 0");
}

}  // namespace

const Table<GivenDamage> damage_keys{
    "materials.damage",
    "a map {D1: number, D2: number, D3: number, D4: number, D5: number}",
    {
        {"D1", value(&GivenDamage::d1, any_number), "-",
         "Strain at fracture: (D1 + D2 exp(D3 s)) (rate factor with D4) (1 + D5 T*), s the stress triaxiality.",
         required},
        {"D2", value(&GivenDamage::d2, not_negative), "-", "D1 + D2 must be positive.", required},
        {"D3", value(&GivenDamage::d3, any_number), "-", "At most 0: tension makes the material less ductile.",
         required},
        {"D4", value(&GivenDamage::d4, any_number), "-", "Coefficient of the strain rate."},
        {"D5", value(&GivenDamage::d5, any_number), "-", "Coefficient of the temperature; above -1."},
        {"rate", value(&GivenDamage::rate, positive), "1/time", "Reference strain rate of `D4`.", "as of the material"},
        {"rate_form", value(&GivenDamage::rate_form, rate_forms()), "-", "Form of the rate factor.",
         "as of the material"},
        {"critical", value(&GivenDamage::critical, courant), "-",
         "Damage at which a point fails: it loses its deviatoric stress and bears no tension."},
        {"softens", value(&GivenDamage::softens), "-", "Whether the yield stress is multiplied by 1 - damage."},
    },
    judge_damage,
};

const Table<EquationOfState> eos_keys{
    "materials.eos",
    "a map {model: mie_gruneisen or linear_polynomial, ...}",
    {
        {"model", value(&EquationOfState::model, eos_models), "-",
         "Form of the pressure as a function of volume and energy.", required},
        {"c", of("mie_gruneisen"), value(&EquationOfState::c, positive), "velocity",
         "The shock velocity is c + s u, u the particle velocity.", required},
        {"s", of("mie_gruneisen"), value(&EquationOfState::s, not_negative), "-", "See `c`.", required},
        {"gamma", of("mie_gruneisen"), value(&EquationOfState::gamma, not_negative), "-",
         "Gruneisen parameter in the initial state.", required},
        {"C0", of("linear_polynomial"), coefficient(0), "stress",
         "The pressure is C0 + C1 m + C2 m^2 + C3 m^3 + (C4 + C5 m + C6 m^2) e, with m = 1/J - 1."},
        {"C1", of("linear_polynomial"), coefficient(1, positive), "stress",
         "See `C0`; J is the relative volume, e the energy by reference volume.", required},
        {"C2", of("linear_polynomial"), coefficient(2), "stress", "See `C0`; in compression alone."},
        {"C3", of("linear_polynomial"), coefficient(3), "stress", "See `C0`."},
        {"C4", of("linear_polynomial"), coefficient(4), "-", "See `C0`."},
        {"C5", of("linear_polynomial"), coefficient(5), "-", "See `C0`."},
        {"C6", of("linear_polynomial"), coefficient(6), "-", "See `C0`; in compression alone."},
        {"energy", value(&EquationOfState::start_energy, any_number), "energy/volume",
         "Initial energy by reference volume."},
        {"minimum_pressure", value(&EquationOfState::minimum_pressure, not_positive), "stress",
         "Largest tension that the material bears (spall).", "none"},
    },
    nullptr,
    name_of_model,
};

}  // namespace brunt::scene
