// SPDX-License-Identifier: Apache-2.0
// One answer of `brunt depth`, with its query.
#pragma once
#include <cstdint>
#include <string>

#include "depth/penetration_depth.hpp"

namespace brunt::app {

/// Everything of it travels between ranks.
struct DepthRow {
  std::int64_t pose = 0;  ///< from 0; of a scene: the pair
  std::string a, b;       ///< files or parts
  depth::Metric metric = depth::Metric::displacement;
  depth::Answer answer;
  Vec3 centroid = Vec3::Zero();  ///< of A, in the coordinates of its file
  Placement start;
  double least_turn = 0;  ///< smaller turns are within the accuracy of the mode, and reported as none [rad]
  double seconds = 0;
};

/// The share of the depth to which a mode tells a motion: a fast walk ends where about 1e-3 of the length is left to
/// gain (`slope` in walk.hpp), a careful answer is a local minimum to 1e-6 of it (tests/depth/minimum_test.cpp).
[[nodiscard]] constexpr double accuracy_of(bool careful) {
  return careful ? 1e-6 : 1e-3;
}

/// The screw of its motion, in the coordinates of B. A turn below `least_turn` is left out: its axis has no meaning and
/// may lie anywhere. The placement of the answer is exact all the same.
struct PlacedScrew {
  Vec3 axis, point;  ///< unit; [length]
  double degrees, slide;
};
[[nodiscard]] PlacedScrew placed_screw(const DepthRow& row);

}  // namespace brunt::app
