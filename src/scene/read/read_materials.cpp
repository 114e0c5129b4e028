// SPDX-License-Identifier: Apache-2.0
// Materials by model.
#include <fmt/format.h>

#include "read_metals.hpp"
#include "scene/read/sections.hpp"

namespace brunt::scene {
namespace {

enum class Model { elastic, j2, neo_hookean, johnson_cook, piecewise_linear, hydrodynamic, crushable_foam, rigid };

material::Elastic read_elastic(Section& material) {
  material::Elastic law;
  material.required("density", law.density, positive);
  material.required("young", law.young, positive);
  material.required("poisson", law.poisson, poisson_ratio);
  static const Choices<material::StressRate> rates{
      {{"jaumann", material::StressRate::jaumann}, {"logarithmic", material::StressRate::logarithmic}}, {}};
  material.optional("stress_rate", law.stress_rate, rates);
  return law;
}

material::J2 read_j2(Section& material) {
  const material::Elastic elastic = read_elastic(material);
  material::J2 law{.density = elastic.density,
                   .young = elastic.young,
                   .poisson = elastic.poisson,
                   .table = {},
                   .stress_rate = elastic.stress_rate};
  const bool has_table = material.has("hardening_table");
  for (const char* name : {"yield", "hardening"}) {
    if (has_table && material.has(name)) {
      fault(material.at(name),
            "invalid together with hardening_table; expected yield and hardening, or the table alone");
    }
  }
  if (has_table) {
    read_hardening_table(material.at("hardening_table"), law.table);
    if (!law.table.empty()) law.yield = law.table.front()[1];
  } else {
    material.required("yield", law.yield, positive);
    material.optional("hardening", law.hardening, not_negative);
  }
  material.optional("kinematic", law.kinematic, share);
  return law;
}

/// lambda = K - 2/3 G, or lambda = E nu / ((1 + nu)(1 - 2 nu)), mu = G = E / (2 (1 + nu)).
material::NeoHookean read_neo_hookean(Section& material) {
  material::NeoHookean law;
  material.required("density", law.density, positive);
  const bool by_bulk = material.has("bulk") || material.has("shear");
  const bool by_young = material.has("young") || material.has("poisson");
  if (by_bulk && by_young) {
    fault(material.key(), "invalid constants: both pairs are given; expected young and poisson, or bulk and shear");
  } else if (by_bulk) {
    double bulk = 0;
    material.required("bulk", bulk, positive);
    material.required("shear", law.mu, positive);
    law.lambda = bulk - 2.0 / 3.0 * law.mu;
  } else {
    double young = 0, poisson = 0;
    material.required("young", young, positive);
    material.required("poisson", poisson, poisson_ratio);
    law.lambda = young * poisson / ((1 + poisson) * (1 - 2 * poisson));
    law.mu = young / (2 * (1 + poisson));
  }
  return law;
}

material::Rigid read_rigid(Section& material) {
  material::Rigid law;
  material.required("density", law.density, positive);
  return law;
}

material::Law read_law(Section& material) {
  static const Choices<Model> models{{{"elastic", Model::elastic},
                                      {"j2", Model::j2},
                                      {"neo_hookean", Model::neo_hookean},
                                      {"johnson_cook", Model::johnson_cook},
                                      {"piecewise_linear", Model::piecewise_linear},
                                      {"hydrodynamic", Model::hydrodynamic},
                                      {"crushable_foam", Model::crushable_foam},
                                      {"rigid", Model::rigid}},
                                     {}};
  Model model{};
  if (!material.required("model", model, models)) {
    for (const std::string& name : material.key().tree->keys)
      material.has(name);  // the keys of an unknown model cannot be checked
    return material::Elastic{};
  }
  switch (model) {
    case Model::elastic:
      return read_elastic(material);
    case Model::j2:
      return read_j2(material);
    case Model::rigid:
      return read_rigid(material);
    case Model::johnson_cook:
      return read_johnson_cook(material);
    case Model::piecewise_linear:
      return read_piecewise_linear(material);
    case Model::hydrodynamic:
      return read_hydrodynamic(material);
    case Model::crushable_foam:
      return read_foam(material);
    default:
      return read_neo_hookean(material);
  }
}

}  // namespace

void read_materials(Section& scene, Input& input) {
  for (const auto& [name, key] : entries(scene.at("materials"), "a map of names, each {model: ..., density: ...}")) {
    Section material(key, "a map {model: elastic, j2, neo_hookean, johnson_cook ... or rigid, density: ...}");
    input.materials[name] = material.is_map() ? read_law(material) : material::Elastic{};
    warn_of_units(material, input.materials[name], input);
  }
}

}  // namespace brunt::scene
