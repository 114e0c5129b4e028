// SPDX-License-Identifier: Apache-2.0
// Scenes that tests read or spoil.
#pragma once
#include <string_view>

namespace brunt::scene {

/// A small complete scene; one key a line, so that a test can spoil one line.
inline constexpr std::string_view small_scene = R"(title: small
units: SI
mesh:
  - box:
      part: left
      size: [1, 1, 1]
      elements: [2, 2, 2]
  - box:
      part: right
      size: [1, 1, 1]
      elements: [2, 2, 2]
      at: [1, 0, 0]
materials:
  steel:
    model: j2
    density: 7800
    young: 2.0e11
    poisson: 0.3
    yield: 4.0e8
parts:
  left:
    material: steel
  right:
    material: steel
curves:
  ramp: [[0, 0], [1, 1]]
initial:
  - part: left
    velocity: [1, 0, 0]
rigid_walls:
  - point: [0, 0, 0]
    normal: [0, 0, 1]
    friction: 0
contact:
  - between: [left, right]
    slave: auto
probes:
  - name: tip
    node: 1
    field: velocity
run:
  end: 1.0e-3
  cfl: 0.9
output:
  every: 1.0e-4
  fields: [displacement]
)";

}  // namespace brunt::scene
