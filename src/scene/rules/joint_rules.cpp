// SPDX-License-Identifier: Apache-2.0
// Joints and reference points of rigid parts: what they may connect, and where they exist.
#include <fmt/format.h>

#include <algorithm>

#include "core/excerpt.hpp"
#include "scene/build/rigid_parts.hpp"
#include "scene/reported.hpp"
#include "scene/rules/rules.hpp"

namespace brunt::scene {
namespace {

std::string fault_of(const Input& input, const Joint& joint) {
  const auto& [one, other] = joint.between;
  for (const std::string& part : joint.between)
    if (part != ground_name && !names_rigid_part(input, part))
      return fmt::format("invalid part '{}': it is deformable; expected rigid parts, or one and ground", excerpt(part));
  if (one == ground_name && other == ground_name)
    return "invalid joint of the ground with itself; expected a rigid part";
  if (one != ground_name && other != ground_name && lead_of(input, one) == lead_of(input, other))
    return fmt::format("invalid joint: '{}' and '{}' are one body; expected two rigid bodies", excerpt(one),
                       excerpt(other));
  return {};
}

using Lines = std::vector<std::string>;

void judge_joints(const Input& input, Lines& faults) {
  if (input.joints.empty()) return;
  for (std::size_t k = 0; k < input.joints.size(); ++k)
    if (const std::string what = fault_of(input, input.joints[k]); !what.empty())
      faults.push_back(reported(input, fmt::format("joints.{}.between", k), "{}", what));
  if (std::ranges::find(input.parts, ground_name, &Part::name) != input.parts.end())
    faults.push_back(reported(input, "joints",
                              "invalid in a scene with a part named 'ground', which is the word for space itself; "
                              "expected another name of the part"));
  if (input.relaxation)
    faults.push_back(
        reported(input, "relaxation",
                 "invalid relaxation: joints have no static state before t = 0 in this version; expected no joints"));
  if (input.implicit)
    faults.push_back(reported(input, "joints",
                              "invalid in an implicit scene, which has no joints in this version; expected no joints"));
}

bool has_reference(const Part& part) {
  return part.rigid && part.rigid->reference;
}

void judge_references(const Input& input, Lines& faults) {
  for (const Part& part : input.parts) {
    if (!has_reference(part) || (!input.relaxation && !input.implicit)) continue;
    faults.push_back(reported(input, fmt::format("parts.{}.rigid.reference", part.name),
                              "invalid in {}, whose supports hold the centre of mass; expected no reference",
                              input.implicit ? "an implicit scene" : "a scene with relaxation"));
  }
  for (std::size_t k = 0; k < input.prescribed.size(); ++k) {
    const Prescribed& motion = input.prescribed[k];
    const auto part = std::ranges::find(input.parts, motion.where, &Part::name);
    if (motion.gives != Prescribed::Gives::acceleration || motion.dof >= 3 || part == input.parts.end()) continue;
    if (has_reference(*part))
      faults.push_back(reported(input, fmt::format("prescribed.{}", k),
                                "invalid acceleration of a reference point in this version; expected its velocity or "
                                "displacement, or an accelerated part with a joint there"));
  }
}

/// Only a revolute joint has one angle.
void judge_angles(const Input& input, Lines& faults) {
  for (std::size_t k = 0; k < input.probes.size(); ++k) {
    const auto joint = std::ranges::find(input.joints, input.probes[k].where, &Joint::name);
    if (input.probes[k].field != "angle" || joint == input.joints.end()) continue;
    if (joint->kind != rigid::JointKind::revolute)
      faults.push_back(reported(input, fmt::format("probes.{}.field", k),
                                "invalid field 'angle': '{}' turns about all axes; expected force, moment or gap",
                                excerpt(joint->name)));
  }
}

}  // namespace

std::vector<std::string> faults_of_joints(const Input& input) {
  Lines faults;
  judge_joints(input, faults);
  judge_references(input, faults);
  judge_angles(input, faults);
  return faults;
}

}  // namespace brunt::scene
