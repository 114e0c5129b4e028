// SPDX-License-Identifier: Apache-2.0
#include "depth_along.hpp"

#include <algorithm>
#include <limits>
#include <numeric>
#include <utility>

#include "contact/data/tolerances.hpp"
#include "contact/detection/cones.hpp"

namespace brunt::contact {
namespace {

/// Depths of edges are exact to this share of an element: a tenth of what is warned of by default.
constexpr double resolved_share = 0.01;

/// Normals of the faces that meet in the probe's edge.
std::vector<Vec3> own_normals(const Probe& probe, std::span<const WatchedSide> sides,
                              std::span<const LocalIndex> near) {
  std::vector<Vec3> normals;
  if (!probe.on_edge) return normals;
  for (const LocalIndex s : near) {
    const WatchedSide& side = nth(sides, s);
    const auto has = [&](GlobalIndex gid) { return std::ranges::find(side.gid, gid) != side.gid.end(); };
    if (std::ranges::all_of(probe.ends, has)) normals.push_back(side.normal());
  }
  return normals;
}

}  // namespace

bool touches(const Probe& probe, std::span<const GlobalIndex> element) {
  return std::ranges::any_of(element, [&](GlobalIndex gid) {
    return gid != no_index && std::ranges::find(probe.around, gid) != probe.around.end();
  });
}

DepthAlong::DepthAlong(const Probe& probe, double chord, std::span<const WatchedSide> sides,
                       std::span<const LocalIndex> near, const WatchedSurface& watched)
    : mean_element_depth_(watched.surface.mean_element_depth), chord_(chord), on_edge_(probe.on_edge) {
  const std::vector<Vec3> own = own_normals(probe, sides, near);
  std::vector<LocalIndex> all(own.size());
  std::iota(all.begin(), all.end(), LocalIndex{0});
  for (const LocalIndex s : near) {
    const WatchedSide& side = nth(sides, s);
    if (touches(probe, side.element)) continue;
    const bool admits = on_edge_ && admission({all, own}, side.normal(), false) >= watched.tolerances.slight;
    faces_.push_back({side.corners(), side.count(), side.element_depth, admits});
  }
}

/// The distance to the nearest face. An edge that passes through a plate is never far from one: there it is the shorter
/// one of what is inside, and of the distance to the nearest face that the edge can lie on.
Depth DepthAlong::depth_of(std::span<const double> distance) const {
  double nearest = std::numeric_limits<double>::infinity(), opposed = nearest;
  double element_depth = mean_element_depth_;
  for (std::size_t f = 0; f < faces_.size(); ++f) {
    if (distance[f] < nearest) {
      nearest = distance[f];
      element_depth = faces_[f].element_depth;
    }
    if (faces_[f].admits) opposed = std::min(opposed, distance[f]);
  }
  if (!(nearest < 2 * element_depth)) nearest = 2 * element_depth;  // faces farther away were not offered
  return {on_edge_ ? std::max(nearest, std::min(opposed, chord_)) : nearest, element_depth};
}

DepthAlong::Reading DepthAlong::read(const Vec3& x) const {
  Reading reading{.x = x, .distance = {}};
  for (const Face& face : faces_) {
    const auto closest = geometry::closest_point(x, {face.corners.data(), face.count});
    reading.distance.push_back(closest ? (x - closest->point).norm() : std::numeric_limits<double>::infinity());
  }
  reading.depth = depth_of(reading.distance);
  return reading;
}

/// Between two points the distance from a convex face is at most the larger one of theirs; from any, the mean of theirs
/// and half the way between them.
double DepthAlong::bound_between(const Reading& one, const Reading& other) const {
  const double way = (one.x - other.x).norm();
  std::vector<double> most(faces_.size());
  for (std::size_t f = 0; f < faces_.size(); ++f) most[f] = std::max(one.distance[f], other.distance[f]);
  return std::min(depth_of(most).depth, 0.5 * (one.depth.depth + other.depth.depth + way));
}

Depth DepthAlong::deepest(const geometry::Segment& part) const {
  Reading start = read(part.start);
  Depth most = start.depth;
  if (!on_edge_) return most;
  std::vector<std::pair<Reading, Reading>> open{{std::move(start), read(part.end)}};
  if (open.front().second.depth.depth > most.depth) most = open.front().second.depth;
  while (!open.empty()) {
    const auto [one, other] = std::move(open.back());
    open.pop_back();
    if (!(bound_between(one, other) > most.depth + resolved_share * most.of_element)) continue;
    const Reading middle = read(0.5 * (one.x + other.x));
    if (middle.depth.depth > most.depth) most = middle.depth;
    open.emplace_back(one, middle);
    open.emplace_back(middle, other);
  }
  return most;
}

}  // namespace brunt::contact
