// SPDX-License-Identifier: Apache-2.0
// Pass 1 of detect_faces: which faces a node can meet in the step at all, by boxes.
#pragma once
#include <cstring>
#include <limits>
#include <span>
#include <vector>

#include "contact/detection/encounter.hpp"
#include "geometry/box.hpp"
#include "motion_quads.hpp"

namespace brunt::contact {

/// Box and size of each face in the step.
void measure_reach(std::span<const MasterFace> faces, std::span<const NodeMotion> motion, double dt,
                   const Tolerances& tolerances, std::vector<FaceReach>& reach);

/// The box that a node sweeps in a step.
struct Sweep {
  Quad low, high;  ///< corners; the fourth component is infinite, so that it never decides
};

/// margin: half thickness of the node's sheet [length].
BRUNT_INLINE Sweep sweep_of(const NodeMotion& node, double dt, double margin) {
  const Quad start = position_quad(node), end = start + dt * predicted_quad(node);
  Sweep sweep{(start < end ? start : end) - margin, (start > end ? start : end) + margin};
  sweep.low[3] = -std::numeric_limits<double>::infinity();
  sweep.high[3] = std::numeric_limits<double>::infinity();
  return sweep;
}

/// Compares all six bounds without branches, which would be mispredicted.
BRUNT_INLINE bool overlaps(const geometry::Box& box, const Sweep& sweep) {
  static_assert(sizeof(geometry::Box) == 6 * sizeof(double));
  const char* const six = reinterpret_cast<const char*>(&box);
  Quad low, last;  // the low corner and x of the high one; z of the low corner and the high one
  std::memcpy(&low, six, sizeof low);
  std::memcpy(&last, six + sizeof(geometry::Box) - sizeof last, sizeof last);
  const Quad high = __builtin_shufflevector(last, last, 1, 2, 3, 3);
  return all((low <= sweep.high) & (sweep.low <= high));
}

}  // namespace brunt::contact
