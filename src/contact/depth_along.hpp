// SPDX-License-Identifier: Apache-2.0
// How deep a point or a stretch of an edge lies behind the faces of a body.
#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "contact/deep_nodes.hpp"
#include "core/cells.hpp"
#include "geometry/box.hpp"
#include "geometry/closest_point.hpp"
#include "geometry/segments.hpp"

namespace brunt::contact {

/// What may lie in an element: a node, as a segment without length, or an edge.
struct Probe {
  geometry::Segment at{};
  std::array<GlobalIndex, 2> ends{};  ///< gids, a node's twice
  std::span<const std::int32_t> blocks{};
  std::span<const GlobalIndex> around{};  ///< nodes of its elements
  bool on_edge = false;

  [[nodiscard]] geometry::Box box() const { return geometry::bounding_box(std::array{at.start, at.end}); }
};

/// An exterior face with its corners at x_n.
struct WatchedSide {
  GlobalIndex key = 0;
  std::array<std::array<double, 3>, 4> corner{};
  std::array<GlobalIndex, 4> gid{};
  std::array<GlobalIndex, cells::most_corners> element{};
  std::int32_t corner_count = 4;
  double element_depth = 0;
  PlainBox capture{};

  [[nodiscard]] std::size_t count() const { return static_cast<std::size_t>(corner_count); }
  [[nodiscard]] std::array<Vec3, 4> corners() const {
    std::array<Vec3, 4> at;
    for (std::size_t i = 0; i < count(); ++i) at[i] = Vec3(corner[i].data());
    return at;
  }
  /// Unit, outward; of a warped face the mean.
  [[nodiscard]] Vec3 normal() const {
    const std::array<Vec3, 4> at = corners();
    return geometry::area_vector({at.data(), count()}).normalized();
  }
  friend bool operator<(const WatchedSide& a, const WatchedSide& b) { return a.key < b.key; }
};

struct Depth {
  double depth = 0, of_element = 0;  ///< of the element behind the nearest face [length]
};

/// Do the elements around the probe touch this one? element: gids of its nodes, no_index to fill.
bool touches(const Probe& probe, std::span<const GlobalIndex> element);

/// Depth along what of a probe is inside a body, by the faces near it.
class DepthAlong {
 public:
  /// chord: what of the edge is in the body [length]. near: indices of sides, in ascending order.
  DepthAlong(const Probe& probe, double chord, std::span<const WatchedSide> sides, std::span<const LocalIndex> near,
             const WatchedSurface& watched);

  /// The deepest point of a stretch of the probe, exact to `resolved_share` of the element there.
  [[nodiscard]] Depth deepest(const geometry::Segment& part) const;

 private:
  struct Face {
    std::array<Vec3, 4> corners;
    std::size_t count;
    double element_depth;
    bool admits;  ///< the edge can lie on it
  };
  /// A point with its distances from the faces.
  struct Reading {
    Vec3 x;
    std::vector<double> distance;  ///< [length]
    Depth depth{};
  };
  [[nodiscard]] Reading read(const Vec3& x) const;
  [[nodiscard]] Depth depth_of(std::span<const double> distance) const;
  [[nodiscard]] double bound_between(const Reading& one, const Reading& other) const;

  std::vector<Face> faces_;
  double mean_element_depth_, chord_;
  bool on_edge_;
};

}  // namespace brunt::contact
