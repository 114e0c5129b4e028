// SPDX-License-Identifier: Apache-2.0
#include "placement.hpp"

namespace brunt::scene {
namespace {

constexpr const char* rotations = "a map {axis: [x, y, z], degrees: number}, or a list of them";

const Table<Rotation>& rotate_keys() {
  static const Table<Rotation> table{"mesh.rotate", rotations, rotation_rows()};
  return table;
}

/// One after the other.
void read_rotations(const Key& key, Placement& placement) {
  if (!is_list(key)) {
    rotate_keys().read(key, placement.rotate.emplace_back());
    return;
  }
  for (const Key& one : items(key, rotations)) rotate_keys().read(one, placement.rotate.emplace_back());
}

}  // namespace

std::vector<Row<Rotation>> rotation_rows() {
  return {
      {"axis", value(&Rotation::axis, Vector::direction), "-", "Axis of the rotation; its length is irrelevant.",
       required},
      {"degrees", value(&Rotation::degrees, any_number), "degree", "Angle.", required},
  };
}

std::vector<Row<Placement>> placement_rows() {
  return {
      {"scale", value(&Placement::scale, positive), "-", "Factor on all coordinates; applied first."},
      {"rotate", special("map or list", read_rotations, {&rotate_keys()}), "-",
       "Rotation about the origin, or several in sequence; applied second."},
      {"at", value(&Placement::at, Vector::any), "length", "Translation; applied last."},
  };
}

}  // namespace brunt::scene
