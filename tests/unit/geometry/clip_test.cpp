// SPDX-License-Identifier: Apache-2.0
// Known overlaps, polygons that touch or coincide, areas of tilings, slopes against differences.
#include "geometry/clip.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include "core/dual.hpp"

using namespace brunt;
using namespace brunt::geometry;
using Point = PlanePoint<double>;
using Points = std::vector<Point>;

namespace {

std::span<const Point> corners_of(const ClippedPolygon& polygon) {
  return {polygon.point.data(), static_cast<std::size_t>(polygon.corners)};
}

double overlap(const Points& a, const Points& b) {
  return area(corners_of(clip(a, b)));
}

Points turned(const Points& points, double angle, Point shift) {
  Points out;
  for (const Point& p : points)
    out.push_back({std::cos(angle) * p.x - std::sin(angle) * p.y + shift.x,
                   std::sin(angle) * p.x + std::cos(angle) * p.y + shift.y});
  return out;
}

const Points square{{0, 0}, {1, 0}, {1, 1}, {0, 1}}, triangle{{0, 0}, {1, 0}, {0, 1}};

/// A grid of n x n quadrilaterals over [0, 1]^2, inner nodes moved by up to `shift` of a cell.
std::vector<Points> tiling(int n, double shift, std::mt19937& random) {
  std::uniform_real_distribution<double> move(-shift, shift);
  Points node;
  for (int j = 0; j <= n; ++j)
    for (int i = 0; i <= n; ++i) {
      const bool x_inside = i > 0 && i<n, y_inside = j> 0 && j < n;
      node.push_back({(i + (x_inside ? move(random) : 0)) / n, (j + (y_inside ? move(random) : 0)) / n});
    }
  std::vector<Points> cells;
  const auto at = [&](int i, int j) { return node[static_cast<std::size_t>(j * (n + 1) + i)]; };
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i) cells.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)});
  return cells;
}

}  // namespace

TEST_CASE("Overlaps of squares and triangles have their areas") {
  CHECK(overlap(square, square) == Approx(1).epsilon(1e-15));
  CHECK(overlap(square, triangle) == Approx(0.5).epsilon(1e-15));
  CHECK(overlap(triangle, turned(triangle, std::numbers::pi, {1, 1})) == 0);  // they share a side
  CHECK(overlap(square, turned(square, 0, {0.25, 0.5})) == Approx(0.375).epsilon(1e-15));
  CHECK(overlap(square, turned(square, 0, {1, 0})) == 0);
  CHECK(overlap(square, turned(square, 0, {1, 1})) == 0);
  CHECK(overlap(square, turned(square, 0, {3, 0})) == 0);
  const ClippedPolygon star = clip(square, turned(square, std::numbers::pi / 4, {0.5, 0.5 - std::sqrt(0.5)}));
  CHECK(star.corners == 8);  // two squares turned by 45 degrees about one centre: a regular octagon
  CHECK(area(corners_of(star)) == Approx(2 * (std::sqrt(2.0) - 1)).epsilon(1e-14));
  CHECK(overlap(square, {{0, 0}, {1, 0}, {1, 0}, {0, 1}}) == Approx(0.5).epsilon(1e-15));  // a side without length
}

TEST_CASE("A sliver keeps its area, and below the tolerance there is none") {
  for (const double width : {1e-3, 1e-6, 1e-9, 1e-11})
    CHECK(overlap(square, turned(square, 0, {1 - width, 0})) == Approx(width).epsilon(1e-15 / width));
  CHECK(overlap(square, turned(square, 0, {1 - 1e-13, 0})) == 0);
}

TEST_CASE("Over two tilings of a square the overlaps add up to it") {
  std::mt19937 random(1);
  for (const double shift : {0.0, 1e-17, 1e-15, 1e-13, 1e-11, 1e-9, 1e-6, 0.1, 0.3})
    for (const auto& [n, m] : {std::pair{3, 3}, std::pair{4, 4}, std::pair{3, 6}, std::pair{4, 7}}) {
      const std::vector<Points> first = tiling(n, shift, random), second = tiling(m, shift, random);
      double sum = 0;
      for (const Points& a : first) {
        double of_a = 0;
        for (const Points& b : second) of_a += overlap(a, b);
        CHECK(of_a == Approx(area(a)).epsilon(1e-11));
        sum += of_a;
      }
      CHECK(sum == Approx(1).epsilon(shift > 1e-15 && shift < 1e-9 ? 1e-11 : 1e-14));
    }
}

TEST_CASE("Polygons on a coarse grid, with and without a little noise: the area does not depend on the order") {
  std::mt19937 random(2);
  std::uniform_int_distribution<int> grid(0, 3);
  std::uniform_real_distribution<double> noise(-1, 1);
  int seen = 0;
  for (int trial = 0; trial < 20000; ++trial) {
    const double size = std::pow(10.0, -5 - trial % 12);
    const auto polygon = [&] {
      Points points;
      for (int i = 0; i < 3; ++i)
        points.push_back({grid(random) + size * noise(random), grid(random) + size * noise(random)});
      if (area(points) < 0) std::swap(points[0], points[1]);
      return points;
    };
    const Points a = polygon(), b = polygon();
    if (area(a) < 0.4 || area(b) < 0.4) continue;
    ++seen;
    CHECK(std::abs(overlap(a, b) - overlap(b, a)) < 3e-11);
  }
  CHECK(seen > 5000);
}

TEST_CASE("Slopes of the area agree with differences") {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> noise(-0.2, 0.2);
  for (int trial = 0; trial < 50; ++trial) {
    Points a = square, b = turned(square, 0.6, {0.3, 0.1});
    for (Points* points : {&a, &b})
      for (Point& p : *points) p = {p.x + noise(random), p.y + noise(random)};
    const ClippedPolygon polygon = clip(a, b);
    if (polygon.corners < 3) continue;
    for (int direction = 0; direction < 16; ++direction) {
      std::vector<PlanePoint<Dual>> da, db, corner;
      for (const Point& p : a) da.push_back({p.x, p.y});
      for (const Point& p : b) db.push_back({p.x, p.y});
      PlanePoint<Dual>& moved = (direction < 8 ? da : db)[static_cast<std::size_t>(direction % 8 / 2)];
      (direction % 2 == 0 ? moved.x : moved.y).slope = broadcast(1);
      for (int i = 0; i < polygon.corners; ++i)
        corner.push_back(corner_point<Dual>(polygon.recipe[static_cast<std::size_t>(i)], da, db));
      Dual twice = 0.0;
      for (std::size_t i = 2; i < corner.size(); ++i) twice += cross(corner[i - 1] - corner[0], corner[i] - corner[0]);
      const double step = 1e-6;
      const auto shifted = [&](double by) {
        Points first = a, second = b;
        Point& p = (direction < 8 ? first : second)[static_cast<std::size_t>(direction % 8 / 2)];
        (direction % 2 == 0 ? p.x : p.y) += by;
        return overlap(first, second);
      };
      CHECK(0.5 * twice.value[0] == Approx(area(corners_of(polygon))).epsilon(1e-14));
      CHECK(std::abs(0.5 * twice.slope[0] - (shifted(step) - shifted(-step)) / (2 * step)) < 1e-9);
    }
  }
}

TEST_CASE("A quadrilateral with a reflex corner is cut at it") {
  const Points dart{{0, 0}, {1, 0}, {0.2, 0.2}, {0, 1}};
  const ConvexPieces pieces = convex_pieces(dart);
  REQUIRE(pieces.count == 2);
  double sum = 0;
  for (const ConvexPiece& piece : pieces.piece) {
    Points corners;
    for (int i = 0; i < piece.corners; ++i)
      corners.push_back(dart[static_cast<std::size_t>(piece.corner[static_cast<std::size_t>(i)])]);
    CHECK(area(corners) > 0);
    sum += area(corners);
  }
  CHECK(sum == Approx(area(dart)).epsilon(1e-15));
  CHECK(convex_pieces(square).count == 1);
  CHECK(convex_pieces(triangle).count == 1);
}
