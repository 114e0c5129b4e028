// SPDX-License-Identifier: Apache-2.0
#include "depth/body.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <stdexcept>

#include "rigid/surface_moments.hpp"

namespace brunt::depth {
namespace {

constexpr int grid_cells = 24;            // along the longest side of the box
constexpr double whole = 1e-6;            // of a cell: rounding of an integer number of cells
constexpr double most_grid = 30;          // of the requested cells: tested points of the box
constexpr int ascent_steps = 12;          // of a grid point towards greater depth
constexpr double covered_share = 0.9;     // of a ball's radius
constexpr std::size_t most_corners = 32;  // of a convex body treated as a piece: 5,000 triples
constexpr double flat = 1e-9;             // of the radius: corners over a face of a convex body by rounding
constexpr int most_outposts = 200;
constexpr double least_volume = 1e-12;  // of the cube on the box's diagonal

std::vector<Vec3> component_points(const TriangleSurface& surface) {
  std::vector<LocalIndex> root(surface.points.size());
  std::iota(root.begin(), root.end(), 0);
  const auto find = [&](LocalIndex i) {
    while (nth(root, i) != i) {
      LocalIndex& next = nth(root, i);
      next = nth(root, next);
      i = next;
    }
    return i;
  };
  for (const auto& t : surface.triangles)
    for (std::size_t k = 1; k < 3; ++k) {
      const LocalIndex one = find(t[0]), other = find(t[k]);
      nth(root, std::max(one, other)) = std::min(one, other);
    }
  std::vector<Vec3> points;
  std::vector<char> done(surface.points.size(), 0);
  for (const auto& t : surface.triangles) {
    char& seen = nth(done, find(t[0]));
    if (!seen) points.push_back(nth(surface.points, t[0]));
    seen = 1;
  }
  return points;
}

/// Moves away from the nearest point of the surface, by shares of the depth that decrease if it does not grow.
InnerBall risen(const geometry::SlabTree& tree, const Vec3& start, geometry::PointDepth here) {
  InnerBall ball{start, here.depth, 1};
  double share = 0.5;
  for (int i = 0; i < ascent_steps; ++i) {
    const Vec3 up = ball.centre - here.nearest;
    const Vec3 next = ball.centre + share * up;
    const geometry::PointDepth there = point_depth(tree, next);
    if (there.depth > ball.depth) {
      ball = {next, there.depth, 1};
      here = there;
    } else {
      share *= 0.4;
    }
  }
  return ball;
}

bool covered(const InnerBall& ball, const std::vector<InnerBall>& by) {
  return std::any_of(by.begin(), by.end(), [&](const InnerBall& other) {
    return (ball.centre - other.centre).norm() + covered_share * ball.depth <= other.depth;
  });
}

struct GridPoint {
  Vec3 x;
  geometry::PointDepth here;
};

/// Balls at the points, and at the maxima to which they ascend. Points covered by such a ball would ascend towards it
/// and are skipped: near the centre of a round body each depth query costs as much as all its triangles.
std::vector<InnerBall> grid_and_risen_balls(const geometry::SlabTree& tree, std::vector<GridPoint>& grid) {
  std::stable_sort(grid.begin(), grid.end(),
                   [](const GridPoint& a, const GridPoint& b) { return a.here.depth > b.here.depth; });
  std::vector<InnerBall> all, tops;
  for (const GridPoint& point : grid) {
    all.push_back({point.x, point.here.depth, 1});
    if (!covered(all.back(), tops)) tops.push_back(risen(tree, point.x, point.here));
  }
  all.insert(all.end(), tops.begin(), tops.end());
  return all;
}

/// The corners of a convex body, which is itself one piece; empty for other bodies, and for many corners (the depth of
/// a piece is found from all triples of its corners).
std::vector<Vec3> corners_if_convex(const geometry::SlabTree& tree, const MetricShape& shape) {
  if (shape.extremes.size() > most_corners) return {};
  for (const geometry::Triangle& t : tree.triangles) {
    const Vec3 normal = (t[1] - t[0]).cross(t[2] - t[0]).normalized();
    for (const Vec3& x : shape.extremes)
      if (normal.dot(shape.centroid + x - t[0]) > flat * shape.radius) return {};
  }
  std::vector<Vec3> corners;
  for (const Vec3& x : shape.extremes) corners.push_back(shape.centroid + x);
  return corners;
}

/// Of the hull, from the centroid, in coordinates along the axes.
geometry::Box box_along(const MetricShape& shape, const Mat3& axes) {
  geometry::Box box;
  for (const Vec3& x : shape.extremes) extend(box, axes.transpose() * x);
  return box;
}

bool precedes(const Vec3& x, const Vec3& y) {
  return std::lexicographical_compare(x.data(), x.data() + 3, y.data(), y.data() + 3);
}

/// The same surface with its triangles sorted by the positions of their corners, each from its least corner on: walks
/// take pairs of triangles in this order, and rounding would lead another order elsewhere.
TriangleSurface in_order_of_positions(TriangleSurface surface) {
  const auto at = [&](LocalIndex i) -> const Vec3& { return nth(surface.points, i); };
  const auto by_position = [&](LocalIndex i, LocalIndex j) { return precedes(at(i), at(j)); };
  for (auto& t : surface.triangles) std::rotate(t.begin(), std::min_element(t.begin(), t.end(), by_position), t.end());
  std::stable_sort(surface.triangles.begin(), surface.triangles.end(), [&](const auto& s, const auto& t) {
    return std::lexicographical_compare(s.begin(), s.end(), t.begin(), t.end(), by_position);
  });
  return surface;
}

}  // namespace

std::vector<InnerBall> inner_balls(const geometry::SlabTree& tree, const MetricShape& shape, const Mat3& axes,
                                   int most) {
  const geometry::Box box = box_along(shape, axes);
  const Vec3 low = box.low, extent = box.high - low;
  const double cell = extent.maxCoeff() / grid_cells;
  std::array<int, 3> counts{};
  for (int c = 0; c < 3; ++c) nth(counts, c) = std::max(3, static_cast<int>(extent[c] / cell + whole));
  std::vector<GridPoint> grid;
  for (int i = 0; i < counts[0]; ++i)
    for (int j = 0; j < counts[1]; ++j)
      for (int k = 0; k < counts[2]; ++k) {
        const Vec3 share((i + 0.5) / counts[0], (j + 0.5) / counts[1], (k + 0.5) / counts[2]);
        const Vec3 x = shape.centroid + axes * (low + share.cwiseProduct(extent));
        const geometry::PointDepth here = point_depth(tree, x);
        if (here.depth > 0) grid.push_back({x, here});
      }
  std::vector<InnerBall> all = grid_and_risen_balls(tree, grid);
  std::stable_sort(all.begin(), all.end(), [](const InnerBall& a, const InnerBall& b) { return a.depth > b.depth; });
  std::vector<InnerBall> kept;
  for (InnerBall& ball : all) {
    if (static_cast<int>(kept.size()) >= most) break;
    if (covered(ball, kept)) continue;
    ball.factor = point_factor(shape.gyration, ball.centre - shape.centroid);
    kept.push_back(ball);
  }
  return kept;
}

std::vector<Vec3> spread_points(std::span<const Vec3> points, const Vec3& centre, int most) {
  std::vector<Vec3> chosen;
  std::vector<double> distance2(points.size());  // from the chosen ones; initially from the centre
  for (std::size_t i = 0; i < points.size(); ++i) distance2[i] = (points[i] - centre).squaredNorm();
  for (int k = 0; k < most; ++k) {
    const auto farthest = std::max_element(distance2.begin(), distance2.end());
    if (farthest == distance2.end() || (k > 0 && !(*farthest > 0))) break;
    const Vec3 x = nth(points, farthest - distance2.begin());
    for (std::size_t i = 0; i < points.size(); ++i) {
      const double here = (points[i] - x).squaredNorm();
      distance2[i] = k > 0 ? std::min(distance2[i], here) : here;
    }
    chosen.push_back(x);
  }
  return chosen;
}

InnerCells inner_cells(const geometry::SlabTree& tree, const MetricShape& shape, const Mat3& axes, double volume,
                       int count) {
  const geometry::Box box = box_along(shape, axes);
  const Vec3 extent = box.high - box.low;
  InnerCells cells;
  cells.side = std::cbrt(std::max(volume / count, extent.prod() / (most_grid * count)));
  const double half_diagonal = 0.5 * std::numbers::sqrt3 * cells.side;
  std::array<int, 3> counts{};
  for (int c = 0; c < 3; ++c) nth(counts, c) = std::max(1, static_cast<int>(extent[c] / cells.side));
  const Vec3 first(0.5 * (1 - counts[0]), 0.5 * (1 - counts[1]), 0.5 * (1 - counts[2]));
  const Vec3 middle = 0.5 * (box.low + box.high);
  for (int i = 0; i < counts[0]; ++i)
    for (int j = 0; j < counts[1]; ++j)
      for (int k = 0; k < counts[2]; ++k) {
        const Vec3 x = shape.centroid + axes * (middle + cells.side * (first + Vec3(i, j, k)));
        const double depth = depth_above(tree, x, half_diagonal);
        if (!(depth > half_diagonal)) continue;
        cells.centres.push_back(x);
        cells.depths.push_back(depth);
      }
  return cells;
}

Body make_body(const TriangleSurface& given, const BodyOptions& options) {
  if (given.triangles.empty()) throw std::invalid_argument("the surface has no triangles");
  const TriangleSurface surface = in_order_of_positions(given);
  Body body;
  body.tree = geometry::build_slab_tree(surface);
  body.crosses_itself = geometry::distrust_crossings(body.tree).count > 0;
  body.mass = rigid::surface_properties(surface, 1);
  const double diagonal = (body.tree.box.high - body.tree.box.low).norm();
  if (!(body.mass.mass > least_volume * diagonal * diagonal * diagonal))
    throw std::invalid_argument("the volume of the surface is not positive");
  std::vector<Vec3> used;
  used.reserve(3 * surface.triangles.size());
  std::vector<char> taken(surface.points.size(), 0);
  for (const auto& t : surface.triangles)
    for (const LocalIndex corner : t) {
      char& seen = nth(taken, corner);
      if (!seen) used.push_back(nth(surface.points, corner));
      seen = 1;
    }
  // by position: the result does not depend on the order of points and triangles
  std::sort(used.begin(), used.end(), precedes);
  body.shape = metric_shape(used, body.mass);
  body.outposts = spread_points(used, body.mass.centre, most_outposts);
  body.components = component_points(surface);
  const Eigen::SelfAdjointEigenSolver<Mat3> solver(body.shape.gyration);
  body.axes = solver.eigenvectors();
  if (body.axes.determinant() < 0) body.axes.col(2) *= -1;
  body.moments = solver.eigenvalues();
  body.balls = inner_balls(body.tree, body.shape, body.axes, options.balls);
  body.cells = inner_cells(body.tree, body.shape, body.axes, body.mass.mass, options.cells);
  std::vector<std::vector<Vec3>> pieces = options.pieces;
  if (pieces.empty())
    if (std::vector<Vec3> corners = corners_if_convex(body.tree, body.shape); !corners.empty())
      pieces.push_back(std::move(corners));
  for (const std::vector<Vec3>& points : pieces) {
    body.pieces.push_back(convex_piece(points));
    double reach = 0;
    for (const Vec3& x : points) reach = std::max(reach, (x - body.mass.centre).norm());
    body.piece_reach.push_back(reach);
  }
  return body;
}

}  // namespace brunt::depth
