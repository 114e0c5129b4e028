// SPDX-License-Identifier: Apache-2.0
#include "prepared.hpp"

#include <algorithm>
#include <ranges>

#include "contact/contact.hpp"
#include "contact_setup.hpp"
#include "implicit/solver.hpp"
#include "removal.hpp"
#include "scene/build/build.hpp"
#include "time/initialise.hpp"
#include "time/relaxation.hpp"

namespace brunt::app {

implicit::Scene implicit_scene(Prepared& run) {
  return {run.model, run.state, run.scratch, run.links};
}

model::Registry Prepared::registry() {
  model::Registry registry = time::state_registry(model, state);
  if (implicit) implicit::add_arrays(model, *implicit, registry);
  if (!assembled.baseline.empty()) time::add_arrays(model, assembled, registry.arrays);
  if (contact) {
    contact_sums = save_sums(links.ranks, *contact);
    registry.arrays.push_back({"contact_sums", model::StateArray::Entity::global, -1, 1,
                               static_cast<int>(contact_sums.size()), contact_sums.data(), 1, 1, 1, 0, true, true});
  }
  if (contact && contact->derived.remembers) {
    contact_history = contact::history_tables(*contact);
    for (RecordTable& table : contact_history)
      if (contact->derived.elastic_impact || &table != &contact_history.back()) registry.tables.push_back(&table);
  }
  registry.arrays.push_back({"extremes", model::StateArray::Entity::global, -1, 1, extremes_width,
                             reinterpret_cast<double*>(&extremes), 1, 1, 1, 0, true, false});
  registry.arrays.push_back({"worst_energies", model::StateArray::Entity::global, -1, 1, worst_width, extremes.worst, 1,
                             1, 1, 0, true, false, false});  // checkpoints of versions before lack it
  // these make columns go on smoothly; they say nothing of the bodies
  for (auto [name, memory] : {std::pair{"force_memory", &force_memory}, std::pair{"contact_memory", &contact_memory}})
    if (!memory->empty())
      registry.arrays.push_back({name, model::StateArray::Entity::global, -1, 1, static_cast<int>(memory->size()),
                                 memory->data(), 1, 1, 1, 0, true, false});
  if (!driven.saved().empty())  // depends on when it was looked at, and says nothing of the bodies
    registry.arrays.push_back({"driven_parts", model::StateArray::Entity::global, -1, 1,
                               static_cast<int>(driven.saved().size()), driven.saved().data(), 1, 1, 1, 0, true,
                               false});
  return registry;
}

void Prepared::after_restart() {
  time::update_positions(model, state);
  if (implicit) implicit::after_restart(implicit_scene(*this), *implicit);
  follow_alive(*this);
  if (contact) driven.start_clock(state.time - contact->ledger.clock);
  if (contact) contact->driven.clear();
  if (contact) restore_sums(links.ranks, contact_sums, *contact);
  if (contact && contact->derived.remembers) contact::restore_history(contact_history, *contact);
}

void begin_run(Prepared& run) {
  time::begin_run(run.model, run.state, scene::initial_velocities(run.input, run.model),
                  scene::initial_rates(run.input, run.model));
  if (!run.contact) return;
  run.contact_sums = save_sums(run.links.ranks, *run.contact);
  std::ranges::fill(run.contact_sums, 0.0);
  restore_sums(run.links.ranks, run.contact_sums, *run.contact);
}

}  // namespace brunt::app
