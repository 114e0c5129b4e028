// SPDX-License-Identifier: Apache-2.0
// Joints between rigid parts.
#include "scene/read/sections.hpp"

namespace brunt::scene {
namespace {

using rigid::JointKind;

const Choices<JointKind> kinds{{{"ball", JointKind::ball}, {"revolute", JointKind::revolute}},
                               {"cylindrical", "prismatic", "universal", "planar", "free", "fixed"}};

void read_between(const Key& key, Joint& joint) {
  const std::vector<Key> names = items(key, "a list of two rigid parts [a, b], one of which may be ground", 2);
  if (names.size() != 2) return;
  for (std::size_t side = 0; side < 2; ++side) {
    if (is_value(names[side]) && names[side].tree->text == ground_name)
      joint.between[side] = ground_name;
    else
      read(names[side], joint.between[side], Named::part);
  }
}

void judge_joint(const Key& map, Joint& joint) {
  if (!has(map, "type")) return;
  if (joint.kind == JointKind::revolute)
    demand(map, "axis", "three numbers [x, y, z], not all zero");
  else
    refuse_any(map, {"axis"}, "invalid axis of a ball joint, which turns about all axes; expected type: revolute");
}

}  // namespace

const Table<Joint> joint_keys{
    "joints",
    "{name: ..., type: ..., between: [a, b], point: [x, y, z]}",
    {
        {"name", value(&Joint::name, Text{"name", "a name"}), "-", "Name for probes and messages; unique.", required},
        {"type", value(&Joint::kind, kinds), "-", "What it lets the parts do: turn about a point, or about an axis.",
         required},
        {"between", special("list of 2 names", read_between), "-",
         "Two rigid parts of different bodies, or one and `ground`, which is space itself.", required},
        {"point", value(&Joint::point, Vector::any), "length", "Place of the joint at the start, in both parts.",
         required},
        {"axis", value(&Joint::axis, Vector::direction), "-", "Of a revolute joint at the start.",
         "required with revolute"},
        refused<Joint>("angle", {},
                       [](const Key& key, Joint&) {
                         later(key, "an angle at the start", "no such key: joints begin as the parts lie in the mesh");
                       }),
        refused<Joint>("rate", {},
                       [](const Key& key, Joint&) {
                         later(key, "a rate at the start", "no such key, but initial velocities of the parts");
                       }),
    },
    judge_joint,
};

}  // namespace brunt::scene
