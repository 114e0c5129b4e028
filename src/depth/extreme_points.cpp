// SPDX-License-Identifier: Apache-2.0
#include "depth/extreme_points.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "depth/quadratic_program.hpp"

namespace brunt::depth {
namespace {

constexpr int first_directions = 200;  // their supporting points form the initial set
constexpr std::size_t most_supports = 512;
constexpr double proof_accuracy = 1e-13;  // of the size of the body

std::size_t support(std::span<const Vec3> points, const Vec3& direction) {
  std::size_t best = 0;
  double most = -std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double height = direction.dot(points[i]);
    if (height > most) {
      most = height;
      best = i;
    }
  }
  return best;
}

struct Hull {
  std::span<const Vec3> points;
  double size;
  std::vector<std::size_t> set;
  std::vector<char> in_set;
  std::vector<Row<3>> rows;  // of the point under test, one for each of the set

  void add(std::size_t i) {
    if (in_set[i]) return;
    in_set[i] = 1;
    set.push_back(i);
  }

  void lay_row(const Vec3& x, std::size_t i) {
    Row<3> row;
    row.normal = (x - points[i]) / size;
    row.bound = 1;
    rows.push_back(row);
  }

  /// x is the convex combination of the points of the set.
  [[nodiscard]] bool proven(const Vec3& x, const QuadraticProgram<3>& program) const {
    Vec3 sum = Vec3::Zero();
    double total = 0;
    for (std::size_t k = 0; k < program.active().size(); ++k) {
      const std::size_t i = nth(set, program.active()[k]);
      sum += program.weights()[k] * (x - points[i]);
      total += program.weights()[k];
    }
    return sum.norm() <= proof_accuracy * size * total;
  }

  [[nodiscard]] bool inside(std::size_t tested) {
    const Vec3& x = points[tested];
    rows.clear();
    for (const std::size_t i : set) lay_row(x, i);
    QuadraticProgram<3> program(Mat3::Identity(), Vec3::Zero());
    for (;;) {
      const Outcome outcome = program.solve(rows, 0);
      if (outcome == Outcome::infeasible) return proven(x, program);
      if (outcome == Outcome::stalled) return false;
      const std::size_t found = support(points, program.x());
      if (in_set[found] || found == tested || set.size() >= most_supports) return false;
      add(found);
      lay_row(x, found);
    }
  }
};

}  // namespace

std::vector<Vec3> spread_directions(int count) {
  std::vector<Vec3> directions;
  const double golden = std::numbers::pi * (3 - std::sqrt(5.0));
  for (int i = 0; i < count; ++i) {
    const double z = 1 - (2 * i + 1.0) / count, radius = std::sqrt(1 - z * z);
    directions.emplace_back(radius * std::cos(golden * i), radius * std::sin(golden * i), z);
  }
  return directions;
}

std::vector<Vec3> extreme_points(std::span<const Vec3> points) {
  if (points.empty()) return {};
  Vec3 low = points[0], high = low;
  for (const Vec3& point : points) {
    low = low.cwiseMin(point);
    high = high.cwiseMax(point);
  }
  const double size = (high - low).norm();
  if (!(size > 0)) return {points[0]};
  Hull hull{points, size, {}, std::vector<char>(points.size(), 0), {}};
  for (const Vec3& direction : spread_directions(first_directions)) hull.add(support(points, direction));
  std::vector<Vec3> kept;
  for (std::size_t i = 0; i < points.size(); ++i)
    if (hull.in_set[i] || !hull.inside(i)) kept.push_back(points[i]);
  return kept;
}

}  // namespace brunt::depth
