// SPDX-License-Identifier: Apache-2.0
#include "depth_row.hpp"

#include <numbers>

namespace brunt::app {

PlacedScrew placed_screw(const DepthRow& row) {
  depth::RigidMotion motion = row.answer.motion;
  if (depth::rotation_vector(motion.turn).norm() < row.least_turn) motion.turn = depth::Turn::Identity();
  const depth::Screw screw = depth::screw_of(motion);
  return {row.start.rotation * screw.axis, row.start(row.centroid + screw.point), screw.angle * 180 / std::numbers::pi,
          screw.slide};
}

}  // namespace brunt::app
