// SPDX-License-Identifier: Apache-2.0
#include "depth_row.hpp"

#include <numbers>

namespace brunt::app {

PlacedScrew placed_screw(const DepthRow& row) {
  const depth::Screw screw = depth::screw_of(row.answer.motion);
  return {row.start.rotation * screw.axis, row.start(row.centroid + screw.point), screw.angle * 180 / std::numbers::pi,
          screw.slide};
}

}  // namespace brunt::app
