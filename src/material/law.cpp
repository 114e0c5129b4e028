// SPDX-License-Identifier: Apache-2.0
// Lame constants of the virgin material.
#include "material/law.hpp"

namespace brunt::material {
namespace {

ElasticModuli from_young_poisson(double density, double young, double poisson) {
  return {density, young * poisson / ((1 + poisson) * (1 - 2 * poisson)), young / (2 * (1 + poisson))};
}

ElasticModuli moduli_of(const Elastic& law) {
  return from_young_poisson(law.density, law.young, law.poisson);
}
ElasticModuli moduli_of(const J2& law) {
  return from_young_poisson(law.density, law.young, law.poisson);
}
ElasticModuli moduli_of(const NeoHookean& law) {
  return {law.density, law.lambda, law.mu};
}
ElasticModuli moduli_of(const Metal& law) {
  return {law.density, law.bulk - 2.0 / 3.0 * law.shear, law.shear};
}
ElasticModuli moduli_of(const Foam& law) {
  return {law.density, 0, 0.5 * law.young};
}
ElasticModuli moduli_of(const Rigid& law) {
  return {law.density, 0, 0};
}

}  // namespace

ElasticModuli initial_moduli(const Law& law) {
  return std::visit([](const auto& constants) { return moduli_of(constants); }, law);
}

}  // namespace brunt::material
