// SPDX-License-Identifier: Apache-2.0
// One answer of `brunt depth`, with what it was asked about.
#pragma once
#include <cstdint>
#include <string>

#include "brunt/depth/penetration_depth.hpp"

namespace brunt::app {

/// Everything of it travels between ranks.
struct DepthRow {
  std::int64_t pose = 0;  ///< from 0; of a scene: the pair
  std::string a, b;       ///< files or parts
  depth::Metric metric = depth::Metric::displacement;
  depth::Answer answer;
  Vec3 centroid = Vec3::Zero();  ///< of A, in the coordinates of its file
  Placement start;
  double seconds = 0;
};

/// The screw of its motion, in the coordinates of B.
struct PlacedScrew {
  Vec3 axis, point;  ///< unit; [length]
  double degrees, slide;
};
[[nodiscard]] PlacedScrew placed_screw(const DepthRow& row);

}  // namespace brunt::app
