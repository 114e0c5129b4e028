// SPDX-License-Identifier: Apache-2.0
#include "time/sum_forces.hpp"

#include <algorithm>
#include <span>

#include "force/dead_loads.hpp"
#include "force/loads.hpp"
#include "time/bodies.hpp"

namespace brunt::time {

void sum_forces(const model::Model& model, const model::State& state, model::Scratch& scratch, Links& links) {
  links.corner_forces.begin(scratch.slots, 4);
  if (model.turns()) links.corner_moments.begin(scratch.moment_slots, 4);
  if (model.loaded()) force::body_loads(model, state, scratch);
  if (model.loaded()) clear_body_loads(model, scratch);
  std::fill(scratch.moment_load.begin(), scratch.moment_load.end(), Quad{});
  force::add_dead_loads(model, state.time, scratch);
  if (model.loaded())
    for (const LocalIndex node : state.living.dropped) nth(scratch.load, node) = Quad{};
  links.corner_forces.end(scratch.slots, 4, {reinterpret_cast<double*>(scratch.force.data()), 4 * scratch.force.size()},
                          4);
  if (model.turns())
    links.corner_moments.end(scratch.moment_slots, 4,
                             {reinterpret_cast<double*>(scratch.moment.data()), 4 * scratch.moment.size()}, 4);
  if (model.loads.pressure.empty()) return;

  force::pressure_forces(model, state, links.pressure_slots);
  const std::span<const double> slots{reinterpret_cast<const double*>(links.pressure_slots.data()),
                                      4 * links.pressure_slots.size()};
  std::fill(links.pressure_sum.begin(), links.pressure_sum.end(), Quad{});
  for (std::size_t k = 0; k < links.pressure_corners.size(); ++k)
    nth(links.pressure_sum, links.pressure_corners[k].node) += links.pressure_slots[k];
  links.pressure.begin(slots, 4);
  links.pressure.end(slots, 4, {reinterpret_cast<double*>(links.pressure_sum.data()), 4 * links.pressure_sum.size()},
                     4);
  for (std::size_t i = 0; i < scratch.load.size(); ++i) scratch.load[i] += links.pressure_sum[i];
}

}  // namespace brunt::time
