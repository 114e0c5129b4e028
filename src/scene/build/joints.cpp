// SPDX-License-Identifier: Apache-2.0
#include "scene/build/joints.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "core/excerpt.hpp"
#include "scene/build/rigid_parts.hpp"

namespace brunt::scene {
namespace {

/// The body of a part of a joint; no_index for the ground.
LocalIndex body_of(const Input& input, const model::Model& model, const std::string& part) {
  if (part == ground_name) return no_index;
  const auto found = std::ranges::find(model.bodies, lead_of(input, part), &model::RigidBody::part);
  return static_cast<LocalIndex>(found - model.bodies.begin());
}

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

/// Holds or drives a component of the reference point of a body.
void add_support(std::size_t c, std::optional<std::int32_t> drive, model::BodyJoint& pivot) {
  pivot.joint.holds[c] = true;
  if (drive) pivot.drive[c] = drive;
}

/// The support of the body's reference point, if entries of the scene hold or drive its shift.
void build_pivot(const Input& input, const Vec3& reference, LocalIndex index, model::Model& model) {
  model::BodyJoint pivot;
  pivot.point = reference - model.mesh.origin;
  pivot.joint.kind = rigid::JointKind::pivot;
  pivot.joint.holds = {};
  pivot.body = {index, no_index};
  const std::string& part = model.bodies[static_cast<std::size_t>(index)].part;
  for (const Fixed& entry : input.fixed)
    for (std::size_t c = 0; c < 3; ++c)
      if (entry.where == part && entry.dofs[c]) add_support(c, std::nullopt, pivot);
  for (std::size_t k = 0; k < input.prescribed.size(); ++k) {
    const Prescribed& entry = input.prescribed[k];
    if (entry.where == part && entry.dof < 3)
      add_support(static_cast<std::size_t>(entry.dof), static_cast<std::int32_t>(k), pivot);
  }
  if (rigid::rows_of(pivot.joint) > 0) model.joints.push_back(std::move(pivot));
}

}  // namespace

std::vector<std::string> faults_of_joints(const Input& input) {
  std::vector<std::string> faults;
  const auto add = [&](const std::string& key, const std::string& what) {
    faults.push_back(fmt::format("{}: {}", input.at(key), what));
  };
  for (std::size_t k = 0; k < input.joints.size(); ++k)
    if (const std::string what = fault_of(input, input.joints[k]); !what.empty())
      add(fmt::format("joints.{}.between", k), what);
  const bool names_ground = std::ranges::find(input.parts, ground_name, &Part::name) != input.parts.end();
  if (names_ground && !input.joints.empty())
    add("joints", "a part is named 'ground', the word for space itself in joints; expected another name of the part");
  if (input.relaxation && !input.joints.empty())
    add("relaxation",
        "invalid relaxation: joints have no static state before t = 0 in this version; expected no joints");
  const auto is_held = [&](const Part& part) { return part.rigid && part.rigid->reference; };
  for (const Part& part : input.parts) {
    if (!is_held(part)) continue;
    const std::string key = fmt::format("parts.{}.rigid.reference", part.name);
    if (input.relaxation)
      add(key, "invalid in a scene with relaxation, whose supports hold the centre of mass; expected no reference");
    if (input.implicit)
      add(key, "invalid in an implicit scene, whose supports hold the centre of mass; expected no reference");
  }
  for (std::size_t k = 0; k < input.probes.size(); ++k) {
    const auto joint = std::ranges::find(input.joints, input.probes[k].where, &Joint::name);
    if (input.probes[k].field == "angle" && joint != input.joints.end() && joint->kind != rigid::JointKind::revolute)
      add(fmt::format("probes.{}.field", k),
          fmt::format("invalid field 'angle': '{}' turns about all axes; expected force, moment or gap",
                      excerpt(joint->name)));
  }
  if (input.implicit && !input.joints.empty())
    add("joints", "invalid in an implicit scene, which has no joints in this version; expected no joints");
  return faults;
}

void build_joints(const Input& input, model::Model& model) {
  for (const Joint& joint : input.joints) {
    model::BodyJoint built;
    built.name = joint.name;
    built.point = joint.point - model.mesh.origin;
    if (joint.kind == rigid::JointKind::revolute) built.joint = rigid::make_revolute({}, joint.axis);
    for (std::size_t side = 0; side < 2; ++side) built.body[side] = body_of(input, model, joint.between[side]);
    model.joints.push_back(std::move(built));
  }
  for (std::size_t b = 0; b < model.bodies.size(); ++b)
    if (const auto& reference = model.bodies[b].given.reference)
      build_pivot(input, *reference + model.mesh.origin, static_cast<LocalIndex>(b), model);
}

}  // namespace brunt::scene
