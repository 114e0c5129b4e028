// SPDX-License-Identifier: Apache-2.0
#include "scene/build/joints.hpp"

#include <algorithm>

#include "scene/build/rigid_parts.hpp"

namespace brunt::scene {
namespace {

/// The body of a part of a joint; no_index for the ground.
LocalIndex body_of(const Input& input, const model::Model& model, const std::string& part) {
  if (part == ground_name) return no_index;
  const auto found = std::ranges::find(model.bodies, lead_of(input, part), &model::RigidBody::part);
  return static_cast<LocalIndex>(found - model.bodies.begin());
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
  const std::string& part = nth(model.bodies, index).part;
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
