// SPDX-License-Identifier: Apache-2.0
// Forces of constant direction, and the phase that finds a static state before t = 0.
#include <fmt/format.h>

#include "scene/read/sections.hpp"

namespace brunt::scene {
namespace {

DeadLoad read_force(Section& entry) {
  DeadLoad load;
  read_selection(entry, load.where);
  const bool each = entry.has("force"), total = entry.has("total");
  if (each && total)
    fault(entry.key(),
          "invalid entry: force and total are both given; expected one of force: for each node, or total: for all "
          "together");
  else if (!each && !total)
    lacking(entry.key(), {"force", "total"},
            "missing force; expected force: for each node, or total: for all together");
  load.kind = total ? DeadLoad::Kind::total : DeadLoad::Kind::each_node;
  if (each) entry.required("force", load.value, Vector::any);
  if (total) entry.required("total", load.value, Vector::any);
  entry.optional("curve", load.curve, Named::curve);
  return load;
}

DeadLoad read_traction(Section& entry) {
  DeadLoad load{.where = {}, .kind = DeadLoad::Kind::traction, .curve = {}};
  entry.required("set", load.where, "the name of a side set");
  entry.required("value", load.value, Vector::any);
  entry.optional("curve", load.curve, Named::curve);
  return load;
}

template <class Reader>
void read_list(Section& scene, std::string_view name, std::string_view expected, std::vector<DeadLoad>& loads,
               Reader reader) {
  if (!scene.has(name)) return;
  for (const Key& key : items(scene.at(name), fmt::format("a list of {}", expected))) {
    Section entry(key, expected);
    if (entry.is_map()) loads.push_back(reader(entry));
  }
}

/// A static state requires a load.
void read_relaxation(const Key& key, Input& input) {
  Section section(key, "a map {tolerance: number, max_steps: count}");
  Relaxation relaxation;
  constexpr Range open_share{0, 1, false, false, "a number > 0 and < 1"};
  section.optional("tolerance", relaxation.tolerance, open_share);
  section.optional("max_steps", relaxation.max_steps, Count{1, 1'000'000'000'000});
  input.relaxation = relaxation;
  if (!input.gravity && input.pressure.empty() && input.forces.empty() && input.traction.empty())
    fault(key, "invalid without loads; expected gravity, pressure, forces or traction in the scene");
}

}  // namespace

void read_forces(Section& scene, Input& input) {
  read_list(scene, "forces", "{set: name, force: [x, y, z]}", input.forces, read_force);
  read_list(scene, "traction", "{set: name, value: [x, y, z]}", input.traction, read_traction);
  if (scene.has("relaxation")) read_relaxation(scene.at("relaxation"), input);
}

}  // namespace brunt::scene
