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
      {"initial", initial_value(), "-", "[Initial velocities](#motions-supports-and-loads)."},
      {"fixed", fixed_value(), "-", "[Supports](#motions-supports-and-loads)."},
      {"symmetry", symmetry_value(), "-", "[Planes of symmetry](#motions-supports-and-loads)."},
      {"prescribed", prescribed_value(), "-", "[Prescribed motions](#motions-supports-and-loads)."},
      {"pressure", pressure_value(), "-", "[Pressures](#motions-supports-and-loads) on faces."},
      {"forces", forces_value(), "-", "[Dead forces](#motions-supports-and-loads)."},
      {"traction", traction_value(), "-", "[Dead tractions](#motions-supports-and-loads) on faces."},
      {"gravity", gravity_value(), "-", "[Gravity](#motions-supports-and-loads)."},
      {"damping", damping_value(), "-", "[Mass damping](#motions-supports-and-loads)."},
      {"relaxation", relaxation_value(), "-", "[Static initial state](#static-initial-state) of an explicit run."},
      {"remove", remove_value(), "-", "[Removal of elements](#removal-of-elements) at given times."},
      {"rigid_walls", rigid_walls_value(), "-", "[Rigid walls](#rigid-walls)."},
      {"enforcement", enforcement_value(), "-", "[How contact is enforced](#enforcement-of-contact)."},
      {"contact", contact_value(), "-", "[Contact between parts](#contact)."},
      {"search", search_value(), "-", "[How pairs are searched](#search-of-pairs)."},
      {"probes", probes_value(), "-", "[Additional columns](#probes-columns-of-historycsv) of history.csv."},
      {"run", run_value(), "-", "[End and steps](#run-and-results).", required},
      {"guards", guards_value(), "-", "[Thresholds](#guards) of warnings and stops."},
      {"solver", solver_value(), "-", "[Time integration](#implicit-solver).", "`explicit`"},
      {"output", output_value(), "-", "[Fields in state.h5](#run-and-results)."},
      {"history", history_value(), "-", "[Rows of history.csv](#run-and-results)."},
      {"checkpoint", checkpoint_value(), "-", "[Checkpoints](#run-and-results)."},
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
