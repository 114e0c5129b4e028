// SPDX-License-Identifier: Apache-2.0
// Joints between rigid parts.
#include "scene/read/sections.hpp"

namespace brunt::scene {
namespace {

using rigid::JointKind;

void read_between(const Key& key, Joint& joint) {
  const std::vector<Key> names = items(key, "two rigid parts [a, b], or one and ground", 2);
  if (names.size() != 2) return;
  for (std::size_t side = 0; side < 2; ++side) {
    const bool ground = names[side].tree->kind == Tree::Kind::value && names[side].tree->text == ground_name;
    if (ground)
      joint.between[side] = ground_name;
    else
      read(names[side], joint.between[side], Named::part);
  }
}

Joint read_joint(Section& entry) {
  static const Choices<JointKind> kinds{{{"ball", JointKind::ball}, {"revolute", JointKind::revolute}},
                                        {"cylindrical", "prismatic", "universal", "planar", "free", "fixed"}};
  Joint joint;
  entry.required("name", joint.name, "a name");
  const bool has_type = entry.required("type", joint.kind, kinds);
  read_between(entry.at("between"), joint);
  entry.required("point", joint.point, Vector::any);
  if (has_type && joint.kind == JointKind::revolute)
    entry.required("axis", joint.axis, Vector::direction);
  else if (has_type && entry.has("axis"))
    fault(entry.at("axis"), "invalid axis of a ball joint, which turns about all axes; expected type: revolute");
  entry.not_yet("angle", "no angle: joints begin as the parts lie in the mesh");
  entry.not_yet("rate", "no rate; initial velocities of parts");
  return joint;
}

}  // namespace

void read_joints(Section& scene, Input& input) {
  if (!scene.has("joints")) return;
  constexpr std::string_view expected = "a map {name: ..., type: ..., between: [a, b], point: [x, y, z]}";
  for (const Key& key : items(scene.at("joints"), "a list of {name: ..., type: ..., between: [a, b], point: ...}")) {
    Section entry(key, expected);
    if (entry.is_map()) input.joints.push_back(read_joint(entry));
  }
}

}  // namespace brunt::scene
