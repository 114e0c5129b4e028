// SPDX-License-Identifier: Apache-2.0
#include "contact/mortar/segment.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "contact/mortar/fine_segment.hpp"
#include "fan.hpp"

namespace brunt::contact {

namespace {

using geometry::ClippedPolygon;
using geometry::PlanePoint;
using geometry::Polygon;
using Point = PlanePoint<double>;
using SlopedPoint = PlanePoint<Sloped>;

/// The diagonals of a quadrilateral, two edges of a triangle; their cross product points outward.
std::array<Vec3, 2> diagonals(FacetCorners x) {
  if (x.size() == 3) return {x[1] - x[0], x[2] - x[0]};
  return {x[2] - x[0], x[3] - x[1]};
}

/// The master facet projected onto the slave's plane: counter-clockwise, so in the reverse order of its corners.
struct SeenMaster {
  std::size_t corners = 0;
  std::array<std::size_t, 4> corner{};  ///< of the facet
  std::array<Point, 4> point{};
  std::array<double, 4> height{};

  SeenMaster(const SlavePlane& plane, FacetCorners master) : corners(master.size()) {
    for (std::size_t i = 0; i < corners; ++i) {
      corner[i] = i == 0 ? 0 : corners - i;
      const Vec3 from_centre = master[corner[i]] - plane.centre;
      point[i] = {plane.first.dot(from_centre), plane.second.dot(from_centre)};
      height[i] = plane.normal.dot(from_centre);
    }
  }
  [[nodiscard]] Polygon<double> polygon() const { return {point.data(), corners}; }
};

Polygon<double> polygon_of(const SlavePlane& plane) {
  return {plane.point.data(), static_cast<std::size_t>(plane.corners)};
}

bool faces(const SlavePlane& plane, FacetCorners master) {
  const auto [d1, d2] = diagonals(master);
  const Vec3 normal = d1.cross(d2);
  const double size = normal.norm();
  return size > 0 && normal.dot(plane.normal) < opposing_normals * size;  // false if it is not finite
}

/// Whether the bounds of the two facets in the plane do not overlap: excludes most pairs without a segment.
bool apart(Polygon<double> a, Polygon<double> b) {
  const auto beyond = [&](double PlanePoint<double>::*axis) {
    double low[2] = {a[0].*axis, b[0].*axis}, high[2] = {low[0], low[1]};
    for (int side = 0; side < 2; ++side)
      for (const Point& p : side == 0 ? a : b) {
        low[side] = std::min(low[side], p.*axis);
        high[side] = std::max(high[side], p.*axis);
      }
    return low[0] >= high[1] || low[1] >= high[0];
  };
  return beyond(&Point::x) || beyond(&Point::y);
}

/// Corners of the polygon and its centroid as a fan. The centroid, unlike the mean of the corners, is continuous when a
/// corner splits in two, so integrals that the rule does not evaluate exactly remain continuous.
template <class Number>
struct Fan {
  std::array<FanTriangle<Number>, ClippedPolygon::most_corners> triangle;
  std::size_t count = 0;

  Fan(const std::array<PlanePoint<Number>, ClippedPolygon::most_corners>& corner, std::size_t corners, Number third)
      : count(corners) {
    PlanePoint<Number> moment = corner[0] - corner[0];
    Number twice_area = moment.x;
    for (std::size_t i = 2; i < corners; ++i) {
      const PlanePoint<Number> a = corner[i - 1] - corner[0], b = corner[i] - corner[0];
      const Number part = cross(a, b);
      moment = {moment.x + part * (a.x + b.x), moment.y + part * (a.y + b.y)};
      twice_area = twice_area + part;
    }
    const Number scale = third / twice_area;
    const PlanePoint<Number> centre{corner[0].x + scale * moment.x, corner[0].y + scale * moment.y};
    for (std::size_t i = 0; i < corners; ++i) {
      const PlanePoint<Number>&a = corner[i], &b = corner[i + 1 == corners ? 0 : i + 1];
      triangle[i] = {{centre, a, b}, cross(a - centre, b - centre)};
    }
  }
};

/// Facets' corners as independent variables of the derivatives.
std::array<SlopedPoint, 4> seeded(Polygon<double> polygon, int first_direction) {
  std::array<SlopedPoint, 4> out{};
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const int direction = first_direction + 2 * static_cast<int>(i);
    out[i] = {Sloped::coordinate(polygon[i].x, direction), Sloped::coordinate(polygon[i].y, direction + 1)};
  }
  return out;
}

template <class Number>
std::array<PlanePoint<Number>, 4> pick(std::span<const PlanePoint<Number>> corners,
                                       const geometry::ConvexPiece& piece) {
  std::array<PlanePoint<Number>, 4> out{};
  for (std::size_t i = 0; i < static_cast<std::size_t>(piece.corners); ++i) out[i] = nth(corners, piece.corner[i]);
  return out;
}

/// Sums over the convex pieces of the overlap.
class Integration {
 public:
  Integration(const SlavePlane& plane, const SeenMaster& master, bool with_slopes)
      : slave_(polygon_of(plane)),
        master_(master.polygon()),
        slave_map_(slave_),
        master_map_(master_),
        with_slopes_(with_slopes) {
    if (!with_slopes) return;
    sloped_slave_ = seeded(slave_, 0);
    sloped_master_ = seeded(master_, plane_directions / 2);
  }

  /// cuts: how often each triangle of the rule is cut into four.
  void run(double least_area, int cuts = 0) {
    cuts_ = cuts;
    const geometry::ConvexPieces slaves = geometry::convex_pieces(slave_), masters = geometry::convex_pieces(master_);
    for (int s = 0; s < slaves.count; ++s)
      for (int m = 0; m < masters.count; ++m) add(nth(slaves.piece, s), nth(masters.piece, m), least_area);
  }

  double area = 0;
  ProductSums sums;
  std::array<ProductSlopes, slope_packs> slopes;

 private:
  void add(const geometry::ConvexPiece& slave, const geometry::ConvexPiece& master, double least_area) {
    const auto s = static_cast<std::size_t>(slave.corners), m = static_cast<std::size_t>(master.corners);
    const std::array<Point, 4> subject = pick(slave_, slave), clip = pick(master_, master);
    const ClippedPolygon polygon = geometry::clip(Polygon<double>{subject.data(), s}, Polygon<double>{clip.data(), m});
    const auto corners = static_cast<std::size_t>(polygon.corners);
    const double of_polygon = geometry::area(std::span(polygon.point.data(), corners));
    if (!(of_polygon > least_area)) return;
    area += of_polygon;
    const Fan<double> fan(polygon.point, corners, 1.0 / 3);
    std::array<FanFunctions, ClippedPolygon::most_corners> functions;
    for (std::size_t i = 0; i < fan.count; ++i) add_triangle(fan.triangle[i], cuts_, functions[i]);
    if (!with_slopes_) return;
    const auto sloped_subject = pick(Polygon<Sloped>(sloped_slave_), slave),
               sloped_clip = pick(Polygon<Sloped>(sloped_master_), master);
    std::array<SlopedPoint, ClippedPolygon::most_corners> corner;
    for (std::size_t i = 0; i < corners; ++i)
      corner[i] = geometry::corner_point(polygon.recipe[i], Polygon<Sloped>{sloped_subject.data(), s},
                                         Polygon<Sloped>{sloped_clip.data(), m});
    Sloped third;
    third.value = 1.0 / 3;
    const Fan<Sloped> sloped(corner, corners, third);
    for (int p = 0; p < slope_packs; ++p)
      for (std::size_t i = 0; i < sloped.count; ++i)
        add_product_slopes(sloped.triangle[i], functions[i], p, nth(slopes, p));
  }

  void add_triangle(const FanTriangle<double>& triangle, int cuts, FanFunctions& functions) {
    if (cuts == 0) return add_products(slave_map_, master_map_, triangle, sums, functions);
    const auto& [a, b, c] = triangle.corner;
    const auto middle = [](const Point& p, const Point& q) { return Point{0.5 * (p.x + q.x), 0.5 * (p.y + q.y)}; };
    const Point ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
    for (const auto& corner :
         {std::array{a, ab, ca}, std::array{ab, b, bc}, std::array{ca, bc, c}, std::array{ab, bc, ca}})
      add_triangle({corner, 0.25 * triangle.twice_area}, cuts - 1, functions);
  }

  Polygon<double> slave_, master_;
  FacetMap slave_map_, master_map_;
  int cuts_ = 0;
  std::array<SlopedPoint, 4> sloped_slave_, sloped_master_;
  bool with_slopes_;
};

void take_values(const SlavePlane& plane, const SeenMaster& master, const Integration& from,
                 SegmentIntegrals& integrals) {
  integrals = {};
  integrals.area = from.area;
  double moment = 0;
  for (std::size_t a = 0; a < 4; ++a) {
    for (std::size_t b = a; b < 4; ++b)
      integrals.slave[a][b] = integrals.slave[b][a] = from.sums[static_cast<int>(SegmentSlopes::pair_of_corners(a, b))];
    for (std::size_t c = 0; c < master.corners; ++c) {
      const double value = from.sums[slave_products + static_cast<int>(4 * a + c)];
      integrals.master[a][master.corner[c]] = value;
      moment += value * master.height[c];
    }
  }
  for (std::size_t a = 0; a < 4; ++a) {
    for (const double value : integrals.slave[a]) integrals.share[a] += value;
    moment -= integrals.share[a] * plane.height[a];
  }
  integrals.distance = moment / from.area;
}

/// From the sixteen coordinates in the plane to the 24 in space. A rotation of the plane by dn moves a corner at height
/// h by -h dn in the plane; translations and rotations of all corners within the plane change no integral.
class ToSpace {
 public:
  ToSpace(const SlavePlane& plane, const SeenMaster& master) : plane_(plane), master_(master) {
    const auto [d1, d2] = plane.diagonal;
    const Vec3* axes[2] = {&plane.first, &plane.second};
    for (std::size_t axis = 0; axis < 2; ++axis) {
      const Vec3 by_d1 = d2.cross(*axes[axis]) / plane.twice_area, by_d2 = axes[axis]->cross(d1) / plane.twice_area;
      std::array<Vec3, 4>& turn = turn_[axis];
      turn.fill(Vec3::Zero());
      turn[0] = -by_d1;
      if (plane.corners == 3) {
        turn[0] -= by_d2;
        turn[1] = by_d1;
        turn[2] = by_d2;
      } else {
        turn[1] = -by_d2;
        turn[2] = by_d1;
        turn[3] = by_d2;
      }
    }
  }

  [[nodiscard]] SegmentSlopes::Slopes operator()(const std::array<ProductSlopes, slope_packs>& slopes,
                                                 std::size_t product) const {
    double in_plane[plane_directions];
    for (int p = 0; p < slope_packs; ++p)
      for (int lane = 0; lane < pack_width; ++lane) in_plane[p * pack_width + lane] = nth(slopes, p).of[product][lane];
    SegmentSlopes::Slopes out{};
    double turn_x = 0, turn_y = 0;
    const auto place = [&](std::size_t to, double height, const double* slope) {
      for (int i = 0; i < 3; ++i)
        out[to + static_cast<std::size_t>(i)] = slope[0] * plane_.first[i] + slope[1] * plane_.second[i];
      turn_x -= height * slope[0];
      turn_y -= height * slope[1];
    };
    for (std::size_t a = 0; a < 4; ++a) place(3 * a, plane_.height[a], in_plane + 2 * a);
    for (std::size_t c = 0; c < master_.corners; ++c)
      place(12 + 3 * master_.corner[c], master_.height[c], in_plane + plane_directions / 2 + 2 * c);
    for (std::size_t a = 0; a < 4; ++a)
      for (int i = 0; i < 3; ++i)
        out[3 * a + static_cast<std::size_t>(i)] += turn_x * turn_[0][a][i] + turn_y * turn_[1][a][i];
    return out;
  }

 private:
  const SlavePlane& plane_;
  const SeenMaster& master_;
  std::array<std::array<Vec3, 4>, 2> turn_;  ///< of each axis . dn by the slave's corners
};

/// Whether the shape functions are polynomials in the plane.
bool has_polynomials(Polygon<double> polygon) {
  if (polygon.size() == 3) return true;
  const FacetMap map(polygon);
  constexpr double straight = 1e-9;
  const auto size = [](const Point& p) { return std::hypot(p.x, p.y); };
  return size(map.twist) <= straight * (size(map.along_xi) + size(map.along_eta));
}

}  // namespace

bool make_slave_plane(FacetCorners slave, SlavePlane& plane) {
  plane.corners = static_cast<int>(slave.size());
  plane.diagonal = diagonals(slave);
  const Vec3 normal = plane.diagonal[0].cross(plane.diagonal[1]);
  plane.twice_area = normal.norm();
  if (!(plane.twice_area > 0) || !std::isfinite(plane.twice_area)) return false;
  plane.normal = normal / plane.twice_area;
  plane.first = (plane.diagonal[0] - plane.normal.dot(plane.diagonal[0]) * plane.normal).normalized();
  plane.second = plane.normal.cross(plane.first);
  plane.centre.setZero();
  for (const Vec3& x : slave) plane.centre += x;
  plane.centre /= static_cast<double>(slave.size());
  plane.point = {};
  plane.height = {};
  for (std::size_t a = 0; a < slave.size(); ++a) {
    const Vec3 from_centre = slave[a] - plane.centre;
    plane.point[a] = {plane.first.dot(from_centre), plane.second.dot(from_centre)};
    plane.height[a] = plane.normal.dot(from_centre);
  }
  return true;
}

bool may_share_segment(const SlavePlane& plane, FacetCorners master) {
  return faces(plane, master) && !apart(polygon_of(plane), SeenMaster(plane, master).polygon());
}

bool integrate_segment(const SlavePlane& plane, FacetCorners master, double capture, SegmentIntegrals& integrals,
                       SegmentSlopes* slopes) {
  if (!faces(plane, master)) return false;
  const SeenMaster seen(plane, master);
  if (apart(polygon_of(plane), seen.polygon())) return false;
  Integration integration(plane, seen, slopes != nullptr);
  integration.run(least_overlap * plane.area());
  if (integration.area == 0) return false;
  take_values(plane, seen, integration, integrals);
  if (!(std::abs(integrals.distance) <= capture)) return false;
  if (slopes == nullptr) return true;
  const ToSpace to_space(plane, seen);
  for (std::size_t product = 0; product < slave_products; ++product)
    slopes->slave[product] = to_space(integration.slopes, product);
  for (std::size_t a = 0; a < 4; ++a)
    for (std::size_t c = 0; c < 4; ++c)
      slopes->master[a][c < seen.corners ? seen.corner[c] : c] =
          to_space(integration.slopes, slave_products + 4 * a + c);
  return true;
}

bool integrate_finely(const SlavePlane& plane, FacetCorners master, double capture, SegmentIntegrals& integrals) {
  if (!faces(plane, master)) return false;
  const SeenMaster seen(plane, master);
  if (apart(polygon_of(plane), seen.polygon())) return false;
  Integration integration(plane, seen, false);
  const bool exact = has_polynomials(polygon_of(plane)) && has_polynomials(seen.polygon());
  integration.run(least_overlap * plane.area(), exact ? 0 : 2);
  if (integration.area == 0) return false;
  take_values(plane, seen, integration, integrals);
  return std::abs(integrals.distance) <= capture;
}

}  // namespace brunt::contact
