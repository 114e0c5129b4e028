// SPDX-License-Identifier: Apache-2.0
// Rigid boxes on each other with friction: forces are their weights, sticking and sliding are Coulomb's, and iterations
// grow with the boxes' degrees of freedom, which is what conjugate residuals take on one set of rows.
#include <catch2/catch.hpp>
#include <cmath>

#include "boxes.hpp"

using namespace brunt;
using namespace brunt::contact;

namespace {

constexpr double step = 1e-3, g = 10;

/// Boxes of mass 1 on a floor that leans by `slope`, after a step of free fall; n and n + 1 points on a side in turn.
struct Stack : BoxProblem {
  Stack(int count, int n, double slope, double of_floor, double between) {
    const Vec3 fall = g * step * Vec3(std::sin(slope), 0, -std::cos(slope));
    for (int b = 0; b < count; ++b) {
      add_box({.centre = {0, 0, 0.5 + b}, .velocity = fall});
      if (b == 0)
        rest_on_floor(0, n);
      else
        rest_on_box(b, b - 1, n + b % 2);
      for (std::size_t q = first_row.empty() ? 0 : first_row.back(); q < rows.size(); ++q)
        if (rows[q].friction == 0) rows[q].friction = b == 0 ? of_floor : between;
      first_row.push_back(rows.size());
    }
  }
  /// Impulse on box b from below.
  [[nodiscard]] Vec3 from_below(std::size_t b) const {
    Vec3 sum = Vec3::Zero();
    for (std::size_t q = b == 0 ? 0 : first_row[b - 1]; q < first_row[b]; ++q) sum += impulses[q];
    return sum;
  }
  std::vector<std::size_t> first_row;  ///< after each box's rows
};

}  // namespace

TEST_CASE("a stack with friction: forces are the weights above") {
  const int boxes = GENERATE(2, 3, 6, 10), n = GENERATE(2, 3);
  constexpr double lean = 0.02;  // 20 boxes would tip from 0.05 on
  Stack p(boxes, n, lean, 0.5, 0.5);
  const EnforcementResult result = p.solve_boxes({.tolerance = 1e-9, .max_iterations = 1000});
  CAPTURE(boxes, n, result.iterations);
  CHECK(result.residual <= 1e-9);
  for (int b = 0; b < boxes; ++b) {
    const Vec3 weight = (boxes - b) * g * step * Vec3(-std::sin(lean), 0, std::cos(lean));
    CHECK((p.from_below(static_cast<std::size_t>(b)) - weight).norm() < 1e-6 * g * step * boxes);
  }
}

TEST_CASE("a stack with friction, soft rows: iterations grow no faster than its height, not with its points") {
  const int boxes = GENERATE(2, 3, 6, 10, 20), n = GENERATE(2, 3, 6);
  Stack p(boxes, n, 0.02, 0.5, 0.5);
  for (Row& row : p.rows) row.softness = 0.05;
  for (int k = 0; k < 30; ++k) {
    const EnforcementResult result = p.solve_boxes({.max_iterations = 1000});
    CAPTURE(boxes, n, k, result.iterations);
    CHECK(result.residual <= 1e-3);
    // seen, 6 x 6 points: 31, 45, 86, 145, 198 from nothing, then at most 32, 60, 98, 110, 124
    CHECK(result.iterations <= 12 * boxes + 40);
  }
}

TEST_CASE("a stack on an incline sticks below the angle of friction and slides above it, as one and without opening") {
  const int boxes = GENERATE(1, 2, 3), n = GENERATE(2, 4);
  const double slope = GENERATE(0.2, 0.28, 0.3, 0.4), friction = 0.3;  // atan 0.3 = 0.2915
  Stack p(boxes, n, slope, friction, 2);
  for (Row& row : p.rows) row.softness = 0.05;
  EnforcementResult result;
  for (int k = 0; k < 300; ++k) {
    result = p.solve_boxes({});
    CAPTURE(boxes, n, slope, k, result.iterations);
    CHECK(result.residual <= 1e-3);  // none ends at the limit; seen: 164 iterations, three boxes near tipping
  }
  CAPTURE(boxes, n, slope);
  const double speed = g * step * std::max(0.0, std::sin(slope) - friction * std::cos(slope));
  for (int b = 0; b < boxes; ++b) CHECK((p.velocity_of(b) - Vec3(speed, 0, 0)).norm() < 1e-3 * g * step);
  const Vec3 floor = p.from_below(0);
  CHECK(floor.z() == Approx(boxes * g * step * std::cos(slope)).epsilon(1e-3));
  if (speed > 0) CHECK(-floor.x() == Approx(friction * floor.z()).epsilon(1e-3));
}

TEST_CASE("a box that spins on the floor: friction of all points against their slip, without opening") {
  const int n = GENERATE(2, 5);
  BoxProblem p;
  p.add_box({.centre = {0, 0, 0.5}, .velocity = {0.02, 0, -0.01}, .spin = {0, 0, 0.1}});
  p.rest_on_floor(0, n);
  for (Row& row : p.rows) row.friction = 0.2;
  const EnforcementResult result = p.solve_boxes({.tolerance = 1e-9, .max_iterations = 1000});
  CAPTURE(n, result.iterations);
  CHECK(result.residual <= 1e-9);
  CHECK(p.energy(true) < p.energy(false));
  CHECK(std::abs(p.velocity_of(0).z()) < 1e-9);
  for (std::size_t q = 0; q < p.rows.size(); ++q) {
    const Vec3 slip = relative_velocity(p.rows[q], p.velocity) - p.rate(q) * p.rows[q].normal,
               across = p.impulses[q] - p.push(q) * p.rows[q].normal;
    CHECK(p.rate(q) >= -1e-10);
    CHECK((across.norm() <= 0.2 * p.push(q) + 1e-12));
    if (slip.norm() > 1e-6 && p.push(q) > 1e-6) CHECK((across + 0.2 * p.push(q) * slip.normalized()).norm() < 1e-7);
  }
}
