// SPDX-License-Identifier: Apache-2.0
#include "geometry/clip.hpp"

#include <algorithm>
#include <cmath>

#include "core/error.hpp"

namespace brunt::geometry {

namespace {

using Point = PlanePoint<double>;
using Kind = ClipCorner::Kind;

double dot(const Point& a, const Point& b) {
  return a.x * b.x + a.y * b.y;
}

double size(const Point& a) {
  return std::sqrt(dot(a, a));
}

/// The end corner of side `side` of a polygon.
std::size_t after(std::size_t side, std::size_t corners) {
  return side + 1 == corners ? 0 : side + 1;
}

struct Corner {
  ClipCorner recipe;
  Point point{};
  std::size_t side = 0;  ///< the side that begins here, numbered over both polygons
};

/// A polygon during clipping.
struct Work {
  std::array<Corner, ClippedPolygon::most_corners> corner;
  std::size_t count = 0;

  void add(const Corner& next) {
    demand(count < corner.size(), "clip: polygons are convex and have at most four corners each");
    corner[count++] = next;
  }
};

double distance_to_segment(const Point& p, const Point& from, const Point& to) {
  const Point along = to - from, away = p - from;
  const double square = dot(along, along);
  const double at = square > 0 ? std::clamp(dot(away, along) / square, 0.0, 1.0) : 0.0;
  return size({away.x - at * along.x, away.y - at * along.y});
}

class Clipper {
 public:
  Clipper(Polygon<double> subject, Polygon<double> clip) : subject_(subject), clip_(clip) {
    for (const Polygon<double> polygon : {subject, clip}) {
      double extent = 0;
      for (const Point& p : polygon) extent = std::max(extent, size(p - polygon[0]));
      extent_ = std::max(extent_, extent);
    }
    for (std::size_t i = 0; i < subject.size(); ++i)
      now_.add({{Kind::subject, static_cast<std::uint8_t>(i), 0}, subject[i], i});
  }

  /// Keeps the part left of side `j` of the clip polygon; returns false if it is empty.
  bool cut(std::size_t j) {
    const Point from = clip_[j], along = clip_[after(j, clip_.size())] - from;
    const double tolerance = on_side * extent_ * size(along);
    if (size(along) == 0) return true;
    std::array<double, ClippedPolygon::most_corners> inside;
    double most = 0, least = 0;
    for (std::size_t v = 0; v < now_.count; ++v) {
      inside[v] = cross(along, now_.corner[v].point - from);
      most = std::max(most, inside[v]);
      least = std::min(least, inside[v]);
    }
    if (most <= tolerance) return false;
    if (least >= -tolerance) return true;
    Work next;
    const std::size_t side = subject_.size() + j;
    for (std::size_t v = 0; v < now_.count; ++v) {
      const std::size_t u = after(v, now_.count);
      const bool leaves = inside[v] >= -tolerance && inside[u] < -tolerance;
      if (inside[v] >= -tolerance) {
        next.add(now_.corner[v]);
        if (leaves && inside[v] <= tolerance) next.corner[next.count - 1].side = side;
      }
      if (leaves && inside[v] > tolerance) next.add(meet(now_.corner[v], now_.corner[u], side, inside[v], inside[u]));
      if (inside[v] < -tolerance && inside[u] > tolerance) {
        next.add(meet(now_.corner[v], now_.corner[u], side, inside[v], inside[u]));
        next.corner[next.count - 1].side = now_.corner[v].side;
      }
    }
    now_ = next;
    return true;
  }

  [[nodiscard]] ClippedPolygon result() const {
    ClippedPolygon polygon;
    if (now_.count < 3) return polygon;
    polygon.corners = static_cast<int>(now_.count);
    for (std::size_t v = 0; v < now_.count; ++v) {
      polygon.recipe[v] = now_.corner[v].recipe;
      polygon.point[v] = now_.corner[v].point;
    }
    return polygon;
  }

 private:
  /// The intersection of the side that begins at v with side `side` of the clip polygon.
  [[nodiscard]] Corner meet(const Corner& v, const Corner& u, std::size_t side, double inside_v,
                            double inside_u) const {
    Corner corner{recipe_of(v.side, side), {}, side};
    corner.point = corner_point(corner.recipe, subject_, clip_);
    if (distance_to_segment(corner.point, v.point, u.point) <= off_side * extent_) return corner;
    const Corner& nearer = std::abs(inside_v) <= std::abs(inside_u) ? v : u;
    return {nearer.recipe, nearer.point, side};
  }

  /// Of two sides, the second one of the clip polygon.
  [[nodiscard]] ClipCorner recipe_of(std::size_t first, std::size_t second) const {
    const std::size_t n = subject_.size(), m = clip_.size();
    if (first >= n && after(first - n, m) == second - n) return {Kind::clip, static_cast<std::uint8_t>(second - n), 0};
    if (first >= n && after(second - n, m) == first - n) return {Kind::clip, static_cast<std::uint8_t>(first - n), 0};
    return {Kind::crossing, static_cast<std::uint8_t>(first), static_cast<std::uint8_t>(second)};
  }

  Polygon<double> subject_, clip_;
  double extent_ = 0;
  Work now_;
};

}  // namespace

ClippedPolygon clip(Polygon<double> subject, Polygon<double> clip) {
  Clipper clipper(subject, clip);
  for (std::size_t j = 0; j < clip.size(); ++j)
    if (!clipper.cut(j)) return {};
  return clipper.result();
}

double area(std::span<const PlanePoint<double>> corners) {
  double twice = 0;
  for (std::size_t i = 2; i < corners.size(); ++i) twice += cross(corners[i - 1] - corners[0], corners[i] - corners[0]);
  return 0.5 * twice;
}

ConvexPieces convex_pieces(Polygon<double> corners) {
  const std::size_t n = corners.size();
  for (std::size_t i = 0; n == 4 && i < n; ++i) {
    const Point& here = corners[i];
    if (cross(here - corners[(i + 3) % 4], corners[(i + 1) % 4] - here) >= 0) continue;
    const int a = static_cast<int>(i), b = (a + 1) % 4, c = (a + 2) % 4, d = (a + 3) % 4;
    return {2, {ConvexPiece{3, {a, b, c, 0}}, ConvexPiece{3, {a, c, d, 0}}}};
  }
  return {1, {ConvexPiece{static_cast<int>(n), {0, 1, 2, 3}}, ConvexPiece{}}};
}

}  // namespace brunt::geometry
