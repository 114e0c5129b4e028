// SPDX-License-Identifier: Apache-2.0
// Motions, supports and loads of the bodies.
#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "mesh/assemble.hpp"
#include "scene/read/sections.hpp"

namespace brunt::scene {
namespace {

const Choices<int> directions{{{"x", 0}, {"y", 1}, {"z", 2}, {"rx", 3}, {"ry", 4}, {"rz", 5}}, {}};

/// Reads each entry of an optional list with `reader(Section&)`.
template <class Reader>
void read_list(Section& scene, std::string_view name, std::string_view expected, Reader reader) {
  if (!scene.has(name)) return;
  for (const Key& key : items(scene.at(name), fmt::format("a list of {}", expected))) {
    Section entry(key, expected);
    if (entry.is_map()) reader(entry);
  }
}

InitialMotion read_motion(Section& entry) {
  InitialMotion motion;
  read_selection(entry, motion.where);
  entry.optional("velocity", motion.velocity, Vector::any);
  if (entry.has("rotation")) {
    Section rotation(entry.at("rotation"), "a map {axis: [x, y, z], point: [x, y, z], rate: number}");
    rotation.required("axis", motion.spin_axis, Vector::direction);
    rotation.optional("point", motion.spin_point, Vector::any);
    rotation.required("rate", motion.spin_rate, any_number);
  } else if (!entry.has("velocity")) {
    lacking(entry.key(), {"velocity", "rotation"}, "missing velocity or rotation; expected one of them, or both");
  }
  return motion;
}

Fixed read_fixed(Section& entry) {
  Fixed fixed;
  read_selection(entry, fixed.where);
  std::array<bool, 6> marked{};
  if (!entry.required("dofs", marked, directions)) return fixed;
  for (std::size_t c = 0; c < 3; ++c) {
    fixed.dofs[c] = marked[c];
    fixed.turns[c] = marked[c + 3];
  }
  return fixed;
}

bool is_numeric(const Key& key) {
  const bool plain = !key.tree->quoted && !key.tree->text.empty();
  return plain && std::string_view("+-.0123456789").find(key.tree->text.front()) != std::string_view::npos;
}

Prescribed read_prescribed(Section& entry) {
  Prescribed motion;
  read_selection(entry, motion.where);
  entry.required("dof", motion.dof, directions);
  entry.optional("scale", motion.scale, any_number);
  using Gives = Prescribed::Gives;
  const bool displacement = entry.has("displacement"), acceleration = entry.has("acceleration");
  if (static_cast<int>(entry.has("velocity")) + static_cast<int>(displacement) + static_cast<int>(acceleration) > 1)
    fault(entry.key(),
          "invalid entry: more than one kind of motion; expected one of velocity, displacement, acceleration");
  motion.gives = displacement ? Gives::displacement : acceleration ? Gives::acceleration : Gives::velocity;
  constexpr std::array names{"velocity", "displacement", "acceleration"};
  const char* name = names[static_cast<std::size_t>(motion.gives)];
  const Key given = entry.at(name);
  if (given.tree == nullptr) {
    wrong(given, "the name of a curve, or a number for a constant velocity");
  } else if (is_numeric(given) && displacement) {
    wrong(given, "the name of a curve that is 0 at t = 0");
  } else if (is_numeric(given)) {
    double constant = 0;
    if (read(given, constant, any_number)) motion.scale *= constant;
  } else {
    read(given, motion.curve, Named::curve);
  }
  return motion;
}

Pressure read_one_pressure(Section& entry) {
  Pressure pressure;
  entry.required("set", pressure.where, "the name of a side set");
  entry.required("value", pressure.value, any_number);
  entry.optional("curve", pressure.curve, Named::curve);
  return pressure;
}

void read_wall_parts(const Key& key, RigidWall& wall) {
  constexpr std::string_view expected = "a list of at least one part, each once";
  const std::vector<Key> entries = items(key, expected);
  if (key.tree->kind == Tree::Kind::list && entries.empty()) wrong(key, expected);
  for (const Key& entry : entries) {
    std::string part;
    if (!read(entry, part, Named::part)) continue;
    if (std::ranges::find(wall.parts, part) != wall.parts.end())
      wrong(entry, expected);
    else
      wall.parts.push_back(part);
  }
}

RigidWall read_wall(Section& entry, std::size_t index) {
  RigidWall wall{.name = fmt::format("wall{}", index),
                 .point = Vec3::Zero(),
                 .normal = Vec3::UnitZ(),
                 .friction = {},
                 .motion = {}};
  entry.optional("name", wall.name, "a name");
  entry.required("point", wall.point, Vector::any);
  entry.required("normal", wall.normal, Vector::direction);
  read_friction(entry, wall.friction);
  entry.optional("bilateral", wall.bilateral);
  entry.optional("motion", wall.motion, Named::curve);
  if (entry.has("parts")) read_wall_parts(entry.at("parts"), wall);
  return wall;
}

void read_gravity(const Key& key, Input& input) {
  Section section(key, "a map {vector: [x, y, z], curve: name}");
  Gravity gravity;
  section.required("vector", gravity.vector, Vector::any);
  section.optional("curve", gravity.curve, Named::curve);
  input.gravity = gravity;
}

void read_damping(const Key& key, Input& input) {
  Section section(key, "a map {alpha: number, from: time, to: time}");
  Damping damping{.to = infinity};
  section.required("alpha", damping.alpha, not_negative);
  section.optional("from", damping.from, not_negative);
  const bool ends = section.optional("to", damping.to, not_negative);
  if (ends && damping.to <= damping.from) {
    fault(section.at("to"),
          fmt::format("invalid time {}: not later than from, {}; expected a later time", damping.to, damping.from));
  }
  input.damping = damping;
}

}  // namespace

void read_initial(Section& scene, Input& input) {
  read_list(scene, "initial", "{part: name, velocity: [x, y, z]}",
            [&](Section& entry) { input.initial.push_back(read_motion(entry)); });
}

void read_supports(Section& scene, Input& input) {
  read_list(scene, "fixed", "{set: name, dofs: [x, y, z]}",
            [&](Section& entry) { input.fixed.push_back(read_fixed(entry)); });
  read_list(scene, "symmetry", "{point: [x, y, z], normal: [x, y, z]}", [&](Section& entry) {
    Symmetry plane{Vec3::Zero(), Vec3::UnitX()};
    entry.required("point", plane.point, Vector::any);
    entry.required("normal", plane.normal, Vector::direction);
    if (entry.has("rotate")) {
      Section rotate(entry.at("rotate"), "a map {axis: [x, y, z], degrees: number}");
      Rotation turn;
      rotate.required("axis", turn.axis, Vector::direction);
      rotate.required("degrees", turn.degrees, any_number);
      plane.normal = mesh::rotation(turn.axis, turn.degrees) * plane.normal;
    }
    input.symmetry.push_back(plane);
  });
  read_list(scene, "prescribed", "{set: name, dof: x, y or z, velocity: curve}",
            [&](Section& entry) { input.prescribed.push_back(read_prescribed(entry)); });
}

void read_loads(Section& scene, Input& input) {
  read_list(scene, "pressure", "{set: name, value: number, curve: name}",
            [&](Section& entry) { input.pressure.push_back(read_one_pressure(entry)); });
  if (scene.has("gravity")) read_gravity(scene.at("gravity"), input);
  if (scene.has("damping")) read_damping(scene.at("damping"), input);
}

void read_removals(Section& scene, Input& input) {
  static const Choices<bool> nodes{{{"keep", true}, {"drop", false}}, {}};
  read_list(scene, "remove", "{part: name, at: time}", [&](Section& entry) {
    Removal removal;
    read_selection(entry, removal.where);
    entry.required("at", removal.at, not_negative);
    entry.optional("nodes", removal.keeps_nodes, nodes);
    input.remove.push_back(removal);
  });
}

void read_rigid_walls(Section& scene, Input& input) {
  read_list(scene, "rigid_walls", "{point: [x, y, z], normal: [x, y, z]}",
            [&](Section& entry) { input.rigid_walls.push_back(read_wall(entry, input.rigid_walls.size())); });
}

}  // namespace brunt::scene
