// SPDX-License-Identifier: Apache-2.0
// Rigid boxes and rows on their points for tests of enforcement.
#pragma once
#include <Eigen/Geometry>

#include "problem.hpp"

namespace brunt::contact {

struct Box {
  Vec3 centre = Vec3::Zero(), size = Vec3::Ones();
  double mass = 1;
  Vec3 velocity = Vec3::Zero(), spin = Vec3::Zero();

  [[nodiscard]] Mat3 inertia() const {
    const Vec3 square = size.cwiseProduct(size);
    return mass / 12 * Vec3(square[1] + square[2], square[2] + square[0], square[0] + square[1]).asDiagonal();
  }
  [[nodiscard]] Carrier carrier() const {
    Carrier carrier{.centre = centre};
    carrier.mobility.topLeftCorner<3, 3>() = Mat3::Identity() / mass;
    carrier.mobility.bottomRightCorner<3, 3>() = inertia().inverse();
    return carrier;
  }
};

struct BoxProblem : Problem {
  std::vector<Box> boxes;
  std::vector<Carrier> bodies;
  std::vector<CarriedPoint> points;
  std::vector<CoupledBodies> coupled;
  EnforcementScratch scratch;

  LocalIndex add_box(const Box& box) {
    boxes.push_back(box);
    bodies.push_back(box.carrier());
    return static_cast<LocalIndex>(boxes.size()) - 1;
  }
  LocalIndex add_point(LocalIndex body, const Vec3& position) {
    const Box& box = boxes[static_cast<std::size_t>(body)];
    const Vec3 v = box.velocity + box.spin.cross(position - box.centre);
    motion.push_back({position, v, v});
    mobility.push_back({0, Mat3::Identity()});
    points.push_back({static_cast<LocalIndex>(motion.size()) - 1, body, true});
    return points.back().point;
  }
  /// n x n points on the lower (-1) or upper (1) side of a box.
  std::vector<LocalIndex> add_side(LocalIndex body, int n, double side) {
    const Box box = boxes[static_cast<std::size_t>(body)];
    std::vector<LocalIndex> added;
    for (int j = 0; j < n; ++j)
      for (int i = 0; i < n; ++i)
        added.push_back(add_point(
            body, box.centre + box.size.cwiseProduct(Vec3(-0.5 + i / (n - 1.0), -0.5 + j / (n - 1.0), 0.5 * side))));
    return added;
  }
  /// n x n points under a box on a floor that is a wall.
  void rest_on_floor(LocalIndex body, int n) {
    for (const LocalIndex point : add_side(body, n, -1)) add_row({{point, 1}}, Vec3::UnitZ());
  }
  /// n x n points under `upper` on the four corners of the upper side of `lower`, both with the same base.
  void rest_on_box(LocalIndex upper, LocalIndex lower, int n) {
    const std::vector<LocalIndex> corners = add_side(lower, 2, 1), below = add_side(upper, n, -1);
    for (int j = 0; j < n; ++j)
      for (int i = 0; i < n; ++i)
        add_row_over(below[static_cast<std::size_t>(j * n + i)], {corners[0], corners[1], corners[3], corners[2]},
                     i / (n - 1.0), j / (n - 1.0), Vec3::UnitZ());
  }
  [[nodiscard]] Carriers carriers() const { return {points, bodies, coupled}; }
  /// A ball joint of two boxes.
  void join(LocalIndex one, LocalIndex other, const Vec3& point) {
    Eigen::MatrixXd slope(3, 12), apart = Eigen::MatrixXd::Zero(12, 12);
    CoupledBodies pair{.bodies = {one, other}, .mobility = {}, .alone = {}};
    for (int side = 0; side < 2; ++side) {
      const auto body = static_cast<std::size_t>(side == 0 ? one : other);
      const Vec3 arm = point - boxes[body].centre;
      Mat3 cross;
      cross << 0, arm[2], -arm[1], -arm[2], 0, arm[0], arm[1], -arm[0], 0;
      slope.middleCols(6 * side, 3) = (side == 0 ? 1 : -1) * Mat3::Identity();
      slope.middleCols(6 * side + 3, 3) = (side == 0 ? 1 : -1) * cross;
      apart.block(6 * side, 6 * side, 6, 6) = bodies[body].mobility;
      pair.alone.push_back(bodies[body].mobility);
    }
    const Eigen::MatrixXd answers = slope * apart;
    pair.mobility = apart - answers.transpose() * (answers * slope.transpose()).inverse() * answers;
    bodies[static_cast<std::size_t>(one)].mobility = pair.mobility.topLeftCorner(6, 6);
    bodies[static_cast<std::size_t>(other)].mobility = pair.mobility.bottomRightCorner(6, 6);
    coupled.push_back(std::move(pair));
  }
  EnforcementResult solve_boxes(const EnforcementSettings& settings) {
    OneRankExchange exchange;
    return solve_boxes(settings, exchange);
  }
  EnforcementResult solve_boxes(const EnforcementSettings& settings, Exchange& exchange, bool two_passes = false) {
    impulses.resize(rows.size(), Vec3::Zero());
    velocity.resize(motion.size());
    compress(rows, matrix);
    lay_rows_on_bodies(carriers(), motion, scratch.carried, matrix);
    return enforce({matrix, motion, mobility, two_passes, 1, carriers()}, settings, 1.0, exchange, impulses, velocity,
                   scratch);
  }
  [[nodiscard]] const BodyAnswer& answer(LocalIndex body) const {
    return scratch.carried.answer[static_cast<std::size_t>(body)];
  }
  [[nodiscard]] Vec3 velocity_of(LocalIndex body) const {
    return boxes[static_cast<std::size_t>(body)].velocity + answer(body).change.head<3>();
  }
  [[nodiscard]] Vec3 spin_of(LocalIndex body) const {
    return boxes[static_cast<std::size_t>(body)].spin + answer(body).change.tail<3>();
  }
  [[nodiscard]] double energy(bool after) const {
    double sum = kinetic_of_nodes(after);
    for (std::size_t b = 0; b < boxes.size(); ++b) {
      const auto body = static_cast<LocalIndex>(b);
      const Vec3 v = after ? velocity_of(body) : boxes[b].velocity, w = after ? spin_of(body) : boxes[b].spin;
      sum += 0.5 * boxes[b].mass * v.squaredNorm() + 0.5 * w.dot(boxes[b].inertia() * w);
    }
    return sum;
  }
  [[nodiscard]] double kinetic_of_nodes(bool after) const {
    double sum = 0;
    for (std::size_t n = 0; n < motion.size(); ++n)
      if (mobility[n].inverse_mass > 0)
        sum += 0.5 / mobility[n].inverse_mass * (after ? velocity[n] : motion[n].predicted).squaredNorm();
    return sum;
  }
};

}  // namespace brunt::contact
