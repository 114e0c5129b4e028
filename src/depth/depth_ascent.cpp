// SPDX-License-Identifier: Apache-2.0
#include "depth_ascent.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>

namespace brunt::depth {
namespace {

constexpr double first_size = 0.5;   // of the step, in units of the sum, which is
constexpr double least_sum = 0.05;   // of A's radius: lower bound
constexpr double accuracy = 1e-13;   // of A's radius: a predicted gain that ends the ascent
constexpr double feasible = 1e-12;   // of the size
constexpr double weight = 10;        // of the gain against the square of the step, which bounds it by twice the size
constexpr double enough_gain = 0.1;  // of the predicted one, for acceptance of the point
constexpr double good_gain = 0.7;    // of the predicted one: longer steps
constexpr double longer = 2, shorter = 0.25;
constexpr std::size_t most_triangles = 32;  // of a body
constexpr double on_surface = 1e-12;        // of an edge: the direction from a nearer point is undefined

/// Unit vector away from the nearest point of the triangle: into the body, if x lies inside or on it.
Vec3 away_from(const geometry::Triangle& triangle, const Vec3& x, const Vec3& nearest) {
  const Vec3 away = x - nearest;
  const double length = away.norm(), size = (triangle[1] - triangle[0]).norm();
  if (length > on_surface * size) return away / length;
  const Vec3 u = triangle[1] - triangle[0], v = triangle[2] - triangle[0];
  return -u.cross(v).normalized();
}

}  // namespace

DepthAscent::DepthAscent(const Encounter& encounter, Metric metric)
    : encounter_(encounter), metric_(metric), inverse_gyration_(encounter.a.shape.gyration.inverse()) {}

double DepthAscent::scale_of(const Vec3& in_a) const {
  if (metric_ != Metric::object_norm) return 1;
  return std::sqrt(point_factor(encounter_.a.shape.gyration, in_a - encounter_.a.shape.centroid));
}

SeenPoint DepthAscent::look(const Vec3& y) const {
  SeenPoint seen;
  seen.y = y;
  seen.in_a = encounter_.start.back(y);
  seen.a = point_depth(encounter_.a.tree, seen.in_a);
  if (metric_ == Metric::object_norm && seen.a.depth < 0) {  // outside A; the nearest point of A has no smaller sum
    seen.in_a = seen.a.nearest;
    seen.y = encounter_.start(seen.in_a);
    seen.a.depth = 0;
  }
  seen.b = point_depth(encounter_.b.tree, seen.y);
  seen.sum = seen.a.depth + seen.b.depth + encounter_.apart;
  if (metric_ == Metric::object_norm) {
    // lambda = w . J^-1 w, w = u x x, of the eigenvector u
    const Vec3 x = seen.in_a - encounter_.a.shape.centroid;
    Mat3 cross;
    cross << 0, -x[2], x[1],  //
        x[2], 0, -x[0],       //
        -x[1], x[0], 0;
    const Mat3 arm = cross * inverse_gyration_ * cross.transpose();
    const Eigen::SelfAdjointEigenSolver<Mat3> solver(0.5 * (arm + arm.transpose()));
    const Vec3 u = solver.eigenvectors().col(2), w = u.cross(x);
    seen.scale = std::sqrt(1 + std::max(0.0, solver.eigenvalues()[2]));
    const Vec3 turned = inverse_gyration_ * w, slope = turned.cross(u) / seen.scale;
    seen.scale_slope = encounter_.start.rotation * slope;
  }
  seen.value = seen.sum > 0 ? seen.sum / seen.scale : seen.sum;
  return seen;
}

/// Whether any of them is new.
bool DepthAscent::keep_triangles(const SeenPoint& seen) {
  const auto keep = [](std::vector<LocalIndex>& list, LocalIndex triangle) {
    if (std::find(list.begin(), list.end(), triangle) != list.end()) return false;
    list.push_back(triangle);
    return true;
  };
  const bool new_a = keep(of_a_, seen.a.triangle), new_b = keep(of_b_, seen.b.triangle);
  return new_a || new_b;
}

/// For one body: its depth is an unknown, bounded by the distance to each triangle.
void DepthAscent::lay_rows_of(const geometry::SlabTree& tree, std::vector<LocalIndex>& list, const Vec3& x,
                              const geometry::PointDepth& here, int unknown, const Mat3& out, double size) {
  struct Kept {
    double above;  // distance beyond the depth
    LocalIndex triangle;
    Vec3 slope;
  };
  std::vector<Kept> kept;
  for (const LocalIndex t : list) {
    const geometry::Triangle& triangle = nth(tree.triangles, t);
    const bool first = t == here.triangle;
    // outside, only the nearest triangle counts: the maximum of concave functions
    if (here.depth < 0 && !first) continue;
    const Vec3 nearest = first ? here.nearest : geometry::nearest_point(triangle, x);
    const Vec3 slope = (here.depth < 0 ? -1 : 1) * away_from(triangle, x, nearest);
    kept.push_back({first ? 0 : std::max(0.0, (x - nearest).norm() - here.depth), t, slope});
  }
  if (kept.size() > most_triangles) {  // the farthest ones are removed
    std::sort(kept.begin(), kept.end(), [](const Kept& p, const Kept& q) { return p.above < q.above; });
    kept.resize(most_triangles);
    list.clear();
    for (const Kept& k : kept) list.push_back(k.triangle);
  }
  for (const Kept& k : kept) {
    Row<5> row;
    const Vec3 slope = out * k.slope;
    row.normal.head<3>() = slope;
    row.normal[unknown] = -1;
    row.bound = -k.above / size;
    rows_.push_back(row);
  }
}

void DepthAscent::lay_rows(const SeenPoint& centre, double size) {
  rows_.clear();
  lay_rows_of(encounter_.a.tree, of_a_, centre.in_a, centre.a, 3, encounter_.start.rotation, size);
  lay_rows_of(encounter_.b.tree, of_b_, centre.y, centre.b, 4, Mat3::Identity(), size);
  if (metric_ != Metric::object_norm) return;
  Row<5> inside;  // restricts the step to points of A
  inside.normal[3] = 1;
  inside.bound = -centre.a.depth / size;
  rows_.push_back(inside);
}

SeenPoint DepthAscent::climb(SeenPoint centre, int most_looks) {
  const double radius = encounter_.a.shape.radius;
  of_a_.clear();
  of_b_.clear();
  keep_triangles(centre);
  double size = first_size * std::max(centre.sum, least_sum * radius);
  QuadraticProgram<5>::Matrix G = QuadraticProgram<5>::Matrix::Identity();
  G.topLeftCorner<3, 3>() *= weight;
  for (int i = 0; i < most_looks && size > accuracy * radius; ++i) {
    lay_rows(centre, size);
    QuadraticProgram<5>::Vector g;
    const Vec3 scale_slope = std::max(0.0, centre.value) * centre.scale_slope;
    g.head<3>() = weight * scale_slope;
    g[3] = g[4] = -weight;
    QuadraticProgram<5> program(G, g);
    if (program.solve(rows_, feasible) != Outcome::solved) break;
    const Vec3 step = program.x().head<3>();
    const double promised = size * (program.x()[3] + program.x()[4] - scale_slope.dot(step)) / centre.scale;
    if (!(promised > accuracy * radius)) break;
    const SeenPoint next = look(centre.y + size * step);
    const bool fresh = keep_triangles(next);
    const double gain = next.value - centre.value;
    if (gain > enough_gain * promised) {
      centre = next;
      if (gain > good_gain * promised) size *= longer;
    } else if (!fresh) {
      size *= shorter;
    }
  }
  return centre;
}

}  // namespace brunt::depth
