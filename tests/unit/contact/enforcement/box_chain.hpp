// SPDX-License-Identifier: Apache-2.0
// Rigid boxes above each other that move in steps: four points at the corners of the smaller face between neighbours,
// gaps and their recovery as detection gives them. A small simulation with a closed form to compare with.
#pragma once
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "boxes.hpp"

namespace brunt::contact {

class BoxChain {
 public:
  double dt = 1e-3, recovery = 0.05, longest_recovery = 1e-3;  ///< share of a depth in a step; most of it / size
  Vec3 gravity = Vec3::Zero();
  double friction = 0, softness = 0.05;
  EnforcementSettings settings{};
  BoxProblem p;
  std::vector<double> ends;  ///< height of the lower end of each box
  int most_iterations = 0, steps = 0, at_limit = 0, scaled = 0;
  long iterations = 0;
  double deepest = 0, least_share = 1;

  /// Above all others, at this distance. aside: of its centre.
  void add(const Box& shape, double gap, const Vec3& aside = Vec3::Zero()) {
    Box box = shape;
    box.centre = aside + Vec3(0, 0, top_ + gap + 0.5 * box.size.z());
    ends.push_back(top_ + gap);
    top_ += gap + box.size.z();
    p.add_box(box);
    turn_.emplace_back(Eigen::Quaterniond::Identity());
  }
  /// Of the lowest box: rows with the floor at height 0, or none.
  void lay_rows(bool on_floor) {
    for (std::size_t b = on_floor ? 0 : 1; b < p.boxes.size(); ++b)
      for (const double x : {-0.5, 0.5})
        for (const double y : {-0.5, 0.5}) lay_row(b, x, y);
    p.impulses.assign(p.rows.size(), Vec3::Zero());
  }
  void step() {
    const auto count = p.boxes.size();
    for (std::size_t b = 0; b < count; ++b) p.boxes[b].velocity += dt * gravity;
    place_points();
    for (std::size_t q = 0; q < p.rows.size(); ++q) ask(p.rows[q]);
    const EnforcementResult result = p.solve_boxes(settings);
    ++steps;
    iterations += result.iterations;
    most_iterations = std::max(most_iterations, result.iterations);
    at_limit += ended_at_limit(result, settings) ? 1 : 0;
    scaled += result.scaled_islands > 0 ? 1 : 0;
    least_share = std::min(least_share, result.least_share);
    for (std::size_t b = 0; b < count && result.acted; ++b) {
      const auto body = static_cast<LocalIndex>(b);
      const Vec3 v = p.velocity_of(body), w = p.spin_of(body);
      p.boxes[b].velocity = v;
      p.boxes[b].spin = w;
    }
    for (std::size_t b = 0; b < count; ++b) {
      const Vec3 angle = dt * p.boxes[b].spin;
      p.boxes[b].centre += dt * p.boxes[b].velocity;
      p.bodies[b].centre = p.boxes[b].centre;
      if (angle.norm() > 0) turn_[b] = Eigen::AngleAxisd(angle.norm(), angle.normalized()) * turn_[b];
    }
  }
  [[nodiscard]] double energy() const {
    double sum = 0;
    for (const Box& box : p.boxes)
      sum += 0.5 * box.mass * box.velocity.squaredNorm() + 0.5 * box.spin.dot(box.inertia() * box.spin) -
             box.mass * gravity.dot(box.centre);
    return sum;
  }
  [[nodiscard]] Vec3 momentum() const {
    Vec3 sum = Vec3::Zero();
    for (const Box& box : p.boxes) sum += box.mass * box.velocity;
    return sum;
  }

 private:
  /// At a corner (x, y from -1/2 to 1/2) of the smaller face below box b.
  void lay_row(std::size_t b, double x, double y) {
    const Box upper = p.boxes[b];
    const bool floor = b == 0;
    const Box lower = floor ? upper : p.boxes[b - 1];
    const Box& small = floor || upper.size.x() < lower.size.x() ? upper : lower;
    const Vec3 place = small.centre + Vec3(x * small.size.x(), y * small.size.y(), 0);
    const LocalIndex above = add_point(b, {place.x(), place.y(), ends[b]});
    if (floor) {
      p.add_row({{above, 1}}, Vec3::UnitZ());
    } else {
      const LocalIndex below = add_point(b - 1, {place.x(), place.y(), ends[b - 1] + lower.size.z()});
      p.add_row({{above, 1}, {below, -1}}, Vec3::UnitZ());
    }
    p.rows.back().friction = friction;
    p.rows.back().softness = softness;
  }
  LocalIndex add_point(std::size_t b, const Vec3& place) {
    at_.push_back(place - p.boxes[b].centre);
    return p.add_point(static_cast<LocalIndex>(b), place);
  }
  void place_points() {
    for (std::size_t i = 0; i < p.points.size(); ++i) {
      const auto b = static_cast<std::size_t>(p.points[i].body);
      const Vec3 arm = turn_[b] * at_[i], v = p.boxes[b].velocity + p.boxes[b].spin.cross(arm);
      p.motion[i] = {p.boxes[b].centre + arm, v, v};
    }
  }
  void ask(Row& row) {
    const auto height = [&](int k) {
      return p.motion[static_cast<std::size_t>(row.nodes[static_cast<std::size_t>(k)])].position.z();
    };
    row.gap = height(0) - (row.node_count == 2 ? height(1) : 0.0);
    deepest = std::max(deepest, -row.gap);
    row.required = -row.gap / dt;
    row.gap_share = 0;
    if (row.gap >= 0) return;
    row.required = std::min(-recovery * row.gap, longest_recovery) / dt;
    row.gap_share = row.required * dt / -row.gap;
  }
  std::vector<Vec3> at_;
  std::vector<Eigen::Quaterniond> turn_;
  double top_ = 0;
};

}  // namespace brunt::contact
