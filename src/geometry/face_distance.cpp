// SPDX-License-Identifier: Apache-2.0
// Maps parameters of the unit square to those of the face, with their region.
#include "face_distance.hpp"

#include <algorithm>
#include <cmath>

namespace brunt::geometry {
namespace {

/// `near[k]`: the position is at edge k; edges k-1 and k meet in vertex k.
Region region_at(std::span<const bool> near) {
  constexpr int first_edge = static_cast<int>(Region::edge0), first_vertex = static_cast<int>(Region::vertex0);
  const std::size_t count = near.size();
  for (std::size_t k = 0; k < count; ++k)
    if (near[k] && near[(k + count - 1) % count]) return static_cast<Region>(first_vertex + static_cast<int>(k));
  for (std::size_t k = 0; k < count; ++k)
    if (near[k]) return static_cast<Region>(first_edge + static_cast<int>(k));
  return Region::face;
}

}  // namespace

FacePlace place_on_face(std::size_t corner_count, const TrilinearPlace& at) {
  constexpr double t = face_tolerance;
  double u = std::clamp(at.u, 0.0, 1.0), v = std::clamp(at.v, 0.0, 1.0);
  if (corner_count == 3) {
    const double sum = std::max(u + v, 1.0);
    u /= sum;
    v /= sum;
    const std::array<bool, 3> near{v <= t, u + v >= 1 - t, u <= t};
    return {u, v, region_at(near)};
  }
  const std::array<bool, 4> near{v <= t, u >= 1 - t, v >= 1 - t, u <= t};
  return {2 * u - 1, 2 * v - 1, region_at(near)};
}

}  // namespace brunt::geometry
