// SPDX-License-Identifier: Apache-2.0
// The top level of a scene.
#include <algorithm>

#include "read_enforcement.hpp"
#include "scene/read/sections.hpp"
#include "scene/rules/rules.hpp"
#include "scene/text/units.hpp"

namespace brunt::scene {
namespace {

const Choices<bool>& spaces() {
  static const Choices<bool> words{{{"3d", true}}, {"plane_strain", "axisymmetric", "plane_stress", "2d"}};
  return words;
}

void read_space(const Key& key, Input&) {
  bool solid = true;
  read(key, solid, spaces());
}

std::vector<std::string> names_of_units() {
  std::vector<std::string> all;
  for (const UnitSystem& system : unit_systems()) all.push_back(system.name);
  return all;
}

void read_units(const Key& key, Input& input) {
  const std::vector<std::string> all = names_of_units();
  const std::size_t chosen = read_choice(key, all, {});
  if (chosen < all.size()) input.units = all[chosen];
}

/// What depends on several sections.
void judge_scene(const Key& scene, Input& input) {
  if (input.relaxation && !input.gravity && input.pressure.empty() && input.forces.empty() && input.traction.empty())
    fault(at(scene, "relaxation"),
          "invalid without loads; expected gravity, pressure, forces or traction in the scene");
  judge_enforcement(scene, input);
  judge_names(scene, input);
}

/// In the order of reading: materials before parts, walls and enforcement before contact, the run before the solver.
std::vector<Row<Input>> scene_rows() {
  return {
      {"title", value(&Input::title, Text{"text", "a line of text"}), "-", "Title of the scene, shown in summaries.",
       "empty"},
      {"units", special(quoted_list(names_of_units()), read_units), "-", "The unit system of all values.", required},
      {"space", special(phrase(true, spaces()), read_space), "-", "Dimension of space.", "`3d`"},
      {"mesh", mesh_value(), "-", "[Mesh files and generated bodies](#mesh).", required},
      {"materials", materials_value(), "-", "[Materials](#materials) by name.", required},
      {"parts", parts_value(), "-", "[Parts](#parts) by name: a block of elements with its material.", required},
      {"sets", sets_value(), "-", "[Named selections](#sets-and-curves) of nodes and faces."},
      {"curves", curves_value(), "-", "[Functions of time](#sets-and-curves) by name."},
      {"initial", list_of(&Input::initial, initial_keys), "-", "[Initial velocities](#motions-supports-and-loads)."},
      {"fixed", list_of(&Input::fixed, fixed_keys), "-", "[Supports](#motions-supports-and-loads)."},
      {"symmetry", list_of(&Input::symmetry, symmetry_keys), "-", "[Planes of symmetry](#motions-supports-and-loads)."},
      {"prescribed", list_of(&Input::prescribed, prescribed_keys), "-",
       "[Prescribed motions](#motions-supports-and-loads)."},
      {"pressure", list_of(&Input::pressure, pressure_keys), "-", "[Pressures](#motions-supports-and-loads) on faces."},
      {"forces", list_of(&Input::forces, forces_keys), "-", "[Dead forces](#motions-supports-and-loads)."},
      {"traction", list_of(&Input::traction, traction_keys), "-",
       "[Dead tractions](#motions-supports-and-loads) on faces."},
      {"gravity", map_of(&Input::gravity, gravity_keys), "-", "[Gravity](#motions-supports-and-loads)."},
      {"damping", map_of(&Input::damping, damping_keys), "-", "[Mass damping](#motions-supports-and-loads)."},
      {"relaxation", map_of(&Input::relaxation, relaxation_keys), "-",
       "[Static initial state](#static-initial-state) of an explicit run."},
      {"remove", list_of(&Input::remove, removal_keys), "-",
       "[Removal of elements](#removal-of-elements) at given times."},
      {"rigid_walls", rigid_walls_value(), "-", "[Rigid walls](#rigid-walls)."},
      {"joints", list_of(&Input::joints, joint_keys), "-", "[Joints](#joints) between rigid parts."},
      {"enforcement", map_of(&Input::enforcement, enforcement_keys), "-",
       "[How contact is enforced](#enforcement-of-contact)."},
      {"contact", contact_value(), "-", "[Contact between parts](#contact)."},
      {"search", map_of(search_keys), "-", "[How pairs are searched](#search-of-pairs)."},
      {"probes", list_of(&Input::probes, probe_keys), "-",
       "[Additional columns](#probes-columns-of-historycsv) of history.csv."},
      {"run", map_of(&Input::run, run_keys), "-", "[End and steps](#run-and-results).", required},
      {"guards", map_of(&Input::guards, guards_keys), "-", "[Thresholds](#guards) of warnings and stops."},
      {"solver", solver_value(), "-", "[Time integration](#implicit-solver).", "`explicit`"},
      {"output", map_of(&Input::output, output_keys), "-", "[Fields in state.h5](#run-and-results)."},
      {"history", map_of(history_keys), "-", "[Rows of history.csv](#run-and-results)."},
      {"checkpoint", map_of(checkpoint_keys), "-", "[Checkpoints](#run-and-results)."},
      {"scaling", scaling_value(), "-", "[Growth with the number of ranks](#weak-scaling)."},
  };
}

void gather(const Described& map, std::vector<const Described*>& all) {
  if (std::ranges::find(all, map.name, &Described::name) != all.end()) return;
  all.push_back(&map);
  for (const Described* inside : map.inner) gather(*inside, all);
}

}  // namespace

const Table<Input>& scene_keys() {
  static const Table<Input> table{"scene", "a map of sections: units, mesh, materials, parts, run, ...", scene_rows(),
                                  judge_scene};
  return table;
}

std::vector<const Described*> all_keys() {
  std::vector<const Described*> all;
  gather(scene_keys(), all);
  return all;
}

}  // namespace brunt::scene
