// SPDX-License-Identifier: Apache-2.0
#include "scene/read/read.hpp"

#include <fmt/format.h>

#include "core/error.hpp"
#include "scene/build/joints.hpp"
#include "scene/build/rigid_parts.hpp"
#include "scene/read/sections.hpp"
#include "scene/text/nearest.hpp"
#include "scene/text/overrides.hpp"
#include "scene/text/units.hpp"

namespace brunt::scene {
namespace {

void read_units(Section& scene, Input& input) {
  std::vector<std::string> names;
  for (const UnitSystem& system : unit_systems()) names.push_back(system.name);
  const std::size_t chosen = read_choice(scene.at("units"), names, {});
  if (chosen < names.size()) input.units = names[chosen];
}

void read_head(Section& scene, Input& input) {
  scene.optional("title", input.title, "a line of text");
  read_units(scene, input);
  static const Choices<bool> spaces{{{"3d", true}}, {"plane_strain", "axisymmetric", "plane_stress", "2d"}};
  bool solid = true;
  scene.optional("space", solid, spaces);
}

void note_places(const Tree& tree, const std::string& path, Places& places) {
  for (std::size_t i = 0; i < tree.children.size(); ++i) {
    const std::string name = tree.kind == Tree::Kind::map ? tree.keys[i] : std::to_string(i);
    const std::string below = path.empty() ? name : path + "." + name;
    places.note(below, tree.children[i].place);
    note_places(tree.children[i], below, places);
  }
}

}  // namespace

bool read_selection(Section& entry, std::string& where) {
  const bool part = entry.has("part"), set = entry.has("set");
  if (part && set) {
    fault(entry.key(), "invalid selection: part and set are both given; expected one of them");
    return false;
  }
  if (part) return entry.required("part", where, Named::part);
  if (set) return entry.required("set", where, "the name of a set or part");
  lacking(entry.key(), {"part", "set"}, "missing selection; expected part: name, or set: name");
  return false;
}

Input read_scene(const std::string& text, const std::string& file_name, std::span<const std::string> overrides) {
  Input input;
  input.file = file_name;
  Findings findings;
  Tree tree = parse_yaml(text, file_name, findings.faults);
  if (tree.kind == Tree::Kind::null) findings.faults.throw_if_any();
  apply_overrides(tree, overrides, findings.faults);
  note_places(tree, "", input.places);
  {
    Section scene({&tree, tree.place, "", &findings}, "a map of sections: units, mesh, materials, parts, run, ...");
    if (scene.is_map()) {
      read_head(scene, input);
      read_mesh(scene, input);
      read_sets(scene, input);
      read_curves(scene, input);
      read_materials(scene, input);
      read_parts(scene, input);
      read_initial(scene, input);
      read_supports(scene, input);
      read_loads(scene, input);
      read_forces(scene, input);
      read_removals(scene, input);
      read_rigid_walls(scene, input);
      read_joints(scene, input);
      read_contact(scene, input);
      read_probes(scene, input);
      read_run(scene, input);
      read_guards(scene, input);
      read_solver(scene, input);
      read_scaling(scene);
      check_references(input, scene);
    }
  }
  findings.faults.throw_if_any();
  std::vector<std::string> faults = faults_of_rigid_parts(input);
  for (std::string& fault : faults_of_joints(input)) faults.push_back(std::move(fault));
  if (!faults.empty()) throw InputError(std::move(faults));
  return input;
}

}  // namespace brunt::scene
