// SPDX-License-Identifier: Apache-2.0
// Rigid walls, and the removal of elements at given times.
#include <fmt/format.h>

#include <algorithm>

#include "read_friction.hpp"
#include "scene/read/sections.hpp"
#include "selection.hpp"

namespace brunt::scene {
namespace {

void read_wall_parts(const Key& key, RigidWall& wall) {
  constexpr std::string_view expected = "a list of at least one part, each once";
  const std::vector<Key> entries = items(key, expected);
  if (is_list(key) && entries.empty()) wrong(key, expected);
  for (const Key& entry : entries) {
    std::string part;
    if (!read(entry, part, Named::part)) continue;
    if (std::ranges::find(wall.parts, part) != wall.parts.end())
      wrong(entry, expected);
    else
      wall.parts.push_back(part);
  }
}

const Table<RigidWall> wall_keys{
    "rigid_walls",
    "{point: [x, y, z], normal: [x, y, z]}",
    {
        {"name", inherited<RigidWall>(&RigidWall::name, Text{"name", "a name"}), "-", "Name for probes.",
         "wall0, wall1, ..."},
        {"point", inherited<RigidWall>(&RigidWall::point, Vector::any), "length",
         "A point of the plane. No body may cross the plane at the start, nor may all bodies lie behind it unless "
         "`parts` are named.",
         required},
        {"normal", inherited<RigidWall>(&RigidWall::normal, Vector::direction), "-", "Normal towards the bodies.",
         required},
        {"friction", friction_of<RigidWall>(&RigidWall::friction), "-",
         "Coulomb friction, as for [contact](#contact); a number in implicit scenes."},
        {"bilateral", inherited<RigidWall>(&RigidWall::bilateral), "-",
         "Whether the wall also holds nodes that move away from it."},
        {"motion", value(&RigidWall::motion, Named::curve), "velocity", "Curve of the velocity along the normal.",
         "at rest"},
        {"parts", special("list", read_wall_parts), "-", "Parts on which the wall acts.", "all"},
    },
};

void read_walls(const Key& list, Input& input) {
  for (const Key& key : items(list, "a list of {point: [x, y, z], normal: [x, y, z]}")) {
    RigidWall wall;
    wall.name = fmt::format("wall{}", input.rigid_walls.size());
    if (wall_keys.read(key, wall)) input.rigid_walls.push_back(std::move(wall));
  }
}

const Choices<bool> left_nodes{{{"keep", true}, {"drop", false}}, {}};

}  // namespace

const Table<Removal> removal_keys{
    "remove",
    "{part: name, at: time}",
    joined(selection(&Removal::where, "Part whose elements are deleted.",
                     "Elements with all nodes in the set are deleted."),
           {
               {"at", value(&Removal::at, not_negative), "time", "Time of the deletion.", required},
               {"nodes", value(&Removal::keeps_nodes, left_nodes), "-",
                "Nodes without elements stay as mass points in contact, or nothing acts on them any more."},
           }),
    [](const Key& map, Removal&) { judge_selection(map); },
};

Value<Input> rigid_walls_value() {
  return special("list", read_walls, {&wall_keys});
}

}  // namespace brunt::scene
