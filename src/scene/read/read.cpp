// SPDX-License-Identifier: Apache-2.0
#include "scene/read/read.hpp"

#include "core/error.hpp"
#include "scene/read/sections.hpp"
#include "scene/rules/rules.hpp"
#include "scene/text/overrides.hpp"

namespace brunt::scene {
namespace {

void note_places(const Tree& tree, const std::string& path, Places& places) {
  for (std::size_t i = 0; i < tree.children.size(); ++i) {
    const std::string name = tree.kind == Tree::Kind::map ? tree.keys[i] : std::to_string(i);
    const std::string below = path.empty() ? name : path + "." + name;
    places.note(below, tree.children[i].place);
    note_places(tree.children[i], below, places);
  }
}

}  // namespace

Input read_scene(const std::string& text, const std::string& file_name, std::span<const std::string> overrides) {
  Input input;
  input.file = file_name;
  Findings findings;
  Tree tree = parse_yaml(text, file_name, findings.faults);
  if (tree.kind == Tree::Kind::null) findings.faults.throw_if_any();
  apply_overrides(tree, overrides, findings.faults);
  note_places(tree, "", input.places);
  findings.scene = &tree;
  scene_keys().read({&tree, tree.place, "", &findings}, input);
  findings.faults.throw_if_any();
  input.warnings = std::move(findings.warnings);
  for (const auto& rules : {faults_of_shells, faults_of_rigid_parts, faults_of_joints, faults_of_solver})
    if (std::vector<std::string> faults = rules(input); !faults.empty()) throw InputError(std::move(faults));
  return input;
}

}  // namespace brunt::scene
