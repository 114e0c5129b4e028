// SPDX-License-Identifier: Apache-2.0
// The sections of a scene: the tables of the maps and lists of the top level, and the values of other forms.
#pragma once
#include "scene/input.hpp"
#include "scene/keys/table.hpp"
#include "scene/text/reader.hpp"

namespace brunt::scene {

extern const Table<InitialMotion> initial_keys;
extern const Table<Fixed> fixed_keys;
extern const Table<Symmetry> symmetry_keys;
extern const Table<Prescribed> prescribed_keys;
extern const Table<Pressure> pressure_keys;
extern const Table<DeadLoad> forces_keys;
extern const Table<DeadLoad> traction_keys;
extern const Table<Gravity> gravity_keys;
extern const Table<model::Damping> damping_keys;
extern const Table<Relaxation> relaxation_keys;
extern const Table<Removal> removal_keys;
extern const Table<Joint> joint_keys;
extern const Table<Enforcement> enforcement_keys;
extern const Table<Input> search_keys;
extern const Table<Probe> probe_keys;
extern const Table<Run> run_keys;
extern const Table<Guards> guards_keys;
extern const Table<Output> output_keys;
extern const Table<Input> history_keys;
extern const Table<Input> checkpoint_keys;

Value<Input> mesh_value();
Value<Input> materials_value();
Value<Input> parts_value();
Value<Input> sets_value();
Value<Input> curves_value();
Value<Input> rigid_walls_value();
Value<Input> contact_value();
Value<Input> solver_value();
Value<Input> scaling_value();

/// The keys of the top level.
const Table<Input>& scene_keys();

}  // namespace brunt::scene
