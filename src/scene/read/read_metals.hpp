// SPDX-License-Identifier: Apache-2.0
// Materials for impact: metals that heat and fail, equations of state, foam.
#pragma once
#include <array>
#include <vector>

#include "scene/read/sections.hpp"

namespace brunt::scene {

/// Yield stress over plastic strain; softening is a fault.
void read_hardening_table(const Key& key, std::vector<std::array<double, 2>>& table);

material::Metal read_johnson_cook(Section& material);
material::Metal read_piecewise_linear(Section& material);
material::Metal read_hydrodynamic(Section& material);
material::Foam read_foam(Section& material);

/// The sections `damage` and `eos` of a metal.
void read_damage(Section& material, material::Metal& law);
void read_eos(Section& material, material::Metal& law);

}  // namespace brunt::scene
