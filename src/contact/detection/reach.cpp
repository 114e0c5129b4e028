// SPDX-License-Identifier: Apache-2.0
#include "reach.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "contact/data/tolerances.hpp"

namespace brunt::contact {
namespace {

/// Longest edge [length]. As geometry::longest_edge, but of Quads: it is computed for every face in every step.
BRUNT_INLINE double size_of(const std::array<Quad, 4>& corners, std::size_t count) {
  double longest2 = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const Quad edge = corners[i + 1 < count ? i + 1 : 0] - corners[i], square = edge * edge;
    longest2 = std::max(longest2, square[0] + square[1] + square[2]);
  }
  return std::sqrt(longest2);
}

FaceReach reach_of(const MasterFace& face, std::span<const NodeMotion> motion, double dt,
                   const Tolerances& tolerances) {
  const auto count = static_cast<std::size_t>(face.corner_count);
  std::array<Quad, 4> corners{};
  Quad low{}, high{};
  for (std::size_t i = 0; i < count; ++i) {
    const NodeMotion& corner = nth(motion, face.nodes[i]);
    corners[i] = position_quad(corner);
    const Quad end = corners[i] + dt * predicted_quad(corner);
    if (i == 0) low = high = end;
    low = low < end ? low : end;
    low = low < corners[i] ? low : corners[i];
    high = high > end ? high : end;
    high = high > corners[i] ? high : corners[i];
  }
  FaceReach reach{.box = {}, .size = size_of(corners, count)};
  const double margin = tolerances.reach(reach.size, face.element_depth) + face.half_thickness;
  reach.box = geometry::grown({Vec3(low[0], low[1], low[2]), Vec3(high[0], high[1], high[2])}, margin);
  return reach;
}

}  // namespace

void measure_reach(std::span<const MasterFace> faces, std::span<const NodeMotion> motion, double dt,
                   const Tolerances& tolerances, std::vector<FaceReach>& reach) {
  reach.clear();
  for (const MasterFace& face : faces) reach.push_back(reach_of(face, motion, dt, tolerances));
}

}  // namespace brunt::contact
