// SPDX-License-Identifier: Apache-2.0
// The sections of a scene. Each is the value of a top-level key; its table and its judge stand in one file.
#pragma once
#include "scene/input.hpp"
#include "scene/keys/table.hpp"
#include "scene/text/reader.hpp"

namespace brunt::scene {

Value<Input> mesh_value();
Value<Input> materials_value();
Value<Input> parts_value();
Value<Input> sets_value();
Value<Input> curves_value();
Value<Input> initial_value();
Value<Input> fixed_value();
Value<Input> symmetry_value();
Value<Input> prescribed_value();
Value<Input> pressure_value();
Value<Input> forces_value();
Value<Input> traction_value();
Value<Input> gravity_value();
Value<Input> damping_value();
Value<Input> relaxation_value();
Value<Input> remove_value();
Value<Input> rigid_walls_value();
Value<Input> enforcement_value();
Value<Input> contact_value();
Value<Input> search_value();
Value<Input> probes_value();
Value<Input> run_value();
Value<Input> guards_value();
Value<Input> solver_value();
Value<Input> output_value();
Value<Input> history_value();
Value<Input> checkpoint_value();
Value<Input> scaling_value();

/// The keys of the top level.
const Table<Input>& scene_keys();

}  // namespace brunt::scene
