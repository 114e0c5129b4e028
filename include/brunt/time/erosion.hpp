// SPDX-License-Identifier: Apache-2.0
// Elements leave the model by what has become of them at t_n, at the same place of a step as removals do: their forces
// act a last time, everything after sees them no more.
#pragma once
#include <vector>

#include "brunt/comm/communicator.hpp"
#include "brunt/model/model.hpp"

namespace brunt::time {

/// Elements that a block lost, on all ranks, by criterion.
struct ErosionCount {
  GlobalIndex damage = 0, plastic_strain = 0, pressure = 0, volume = 0, step = 0;
  [[nodiscard]] GlobalIndex all() const { return damage + plastic_strain + pressure + volume + step; }
  ErosionCount& operator+=(const ErosionCount& more) {
    damage += more.damage;
    plastic_strain += more.plastic_strain;
    pressure += more.pressure;
    volume += more.volume;
    step += more.step;
    return *this;
  }
};

/// Sets the flags of the elements that meet a criterion of their block's erosion, with the histories of t_n, and what
/// follows from them; counts: of each block, those of this step. An element is judged on its rank by its own state, so
/// the answer does not depend on the ranks. Returns whether any went. Collective, where any block erodes; else nothing.
bool erode(const comm::Communicator& ranks, const model::Model& model, model::State& state,
           const model::Scratch& scratch, std::vector<ErosionCount>& counts);

}  // namespace brunt::time
