// SPDX-License-Identifier: Apache-2.0
// The sections of a scene file, each read by one function; `scene` is the section of the top-level keys.
#pragma once
#include <string>

#include "scene/input.hpp"
#include "scene/text/reader.hpp"

namespace brunt::scene {

void read_mesh(Section& scene, Input& input);
void read_sets(Section& scene, Input& input);
void read_curves(Section& scene, Input& input);
void read_materials(Section& scene, Input& input);
void read_parts(Section& scene, Input& input);
void read_initial(Section& scene, Input& input);
void read_supports(Section& scene, Input& input);  ///< fixed, symmetry, prescribed
void read_loads(Section& scene, Input& input);     ///< pressure, gravity, damping
void read_forces(Section& scene, Input& input);    ///< forces, traction, relaxation
void read_removals(Section& scene, Input& input);
void read_rigid_walls(Section& scene, Input& input);
void read_joints(Section& scene, Input& input);
void read_contact(Section& scene, Input& input);  ///< contact, enforcement, search
void read_probes(Section& scene, Input& input);
void read_run(Section& scene, Input& input);  ///< run, output, history, checkpoint
void read_guards(Section& scene, Input& input);
void read_solver(Section& scene, Input& input);  ///< solver; after run
void read_scaling(Section& scene);               ///< checked only: scripts/scaling uses it

/// A selection: exactly one of the keys `part` (noted as a reference) and `set`.
bool read_selection(Section& entry, std::string& where);
/// The key `friction`, if there: a coefficient, or a map of static, kinetic, decay and lag.
void read_friction(Section& entry, contact::FrictionLaw& friction);

/// The map `erosion` of a part.
model::Erosion read_erosion(const Key& key);
/// Checks that the material of the part has the quantities that its erosion criteria need. Called when the materials
/// are known.
void check_erosion(const Input& input, const Part& part, const Key& key);

/// Warns of a density or wave speed outside those of known matter, where the scene names its units.
void warn_of_units(Section& material, const material::Law& law, Input& input);

/// Names that are used but not defined, generated parts without an entry in `parts`, names that are used twice.
void check_references(Input& input, Section& scene);

}  // namespace brunt::scene
