// SPDX-License-Identifier: Apache-2.0
// Erosion: elements are removed by their state at t_n, at the same point of a step as prescribed removals. Their forces
// act a last time; afterwards the elements are ignored.
#pragma once
#include <vector>

#include "comm/communicator.hpp"
#include "model/model.hpp"

namespace brunt::time {

/// Numbers of elements removed from a block, on all ranks, by criterion.
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

/// Sets the flags of the elements that meet a criterion of their block's erosion, with the histories of t_n, and
/// updates dependent data; counts: of each block in this step. An element is judged on its rank by its own state, so
/// the result does not depend on the ranks. Returns whether any element was removed. Collective if any block erodes;
/// otherwise it does nothing.
bool erode(const comm::Communicator& ranks, const model::Model& model, model::State& state,
           const model::Scratch& scratch, std::vector<ErosionCount>& counts);

}  // namespace brunt::time
