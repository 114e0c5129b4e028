// SPDX-License-Identifier: Apache-2.0
#include "implicit/walls/wall_node.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <array>

namespace brunt::implicit {
namespace {

constexpr std::size_t most = WallChoice::most;

/// A wall whose normal differs by a smaller share from the directions constrained by supports and other walls is
/// redundant. The rounding of normals is far below, realistic angles between walls are far above.
constexpr double redundant = 1e-6;

/// Planes of a set of walls that constrain a node.
struct Held {
  std::array<std::size_t, most> wall{};  ///< of each column
  int count = 0;
  Mat3 along = Mat3::Zero();        ///< columns: normals along free directions
  Mat3 normals = Mat3::Zero();      ///< columns: normals
  Mat3 inverse = Mat3::Zero();      ///< of along' along, count x count
  Mat3 slides = Mat3::Identity();   ///< projector onto the free directions without a wall
  Mat3 tangent = Mat3::Identity();  ///< likewise onto all of them, including those constrained by supports

  [[nodiscard]] auto columns() const { return along.leftCols(count); }
  /// along (along' along)^-1: transforms gaps to displacements, and its transpose forces to pressures.
  [[nodiscard]] Eigen::Matrix<double, 3, Eigen::Dynamic, 0, 3, 3> lift() const {
    return columns() * inverse.topLeftCorner(count, count);
  }
};

/// Removes the direction of a vector from a projector; returns false if its part in the projector is negligible.
bool take_out(const Vec3& direction, Mat3& projector) {
  const Vec3 rest = projector * direction;
  if (rest.norm() < redundant) return false;
  const Vec3 unit = rest.normalized();
  projector -= unit * unit.transpose();
  return true;
}

Held hold(const WallQuestion& question, const bool (&active)[most]) {
  Held held;
  held.slides = question.free;
  for (std::size_t w = 0; w < question.meetings.size(); ++w) {
    if (!active[w]) continue;
    const Vec3& normal = question.meetings[w].normal;
    if (!take_out(normal, held.slides)) continue;
    take_out(normal, held.tangent);
    held.along.col(held.count) = question.free * normal;
    held.normals.col(held.count) = normal;
    nth(held.wall, held.count++) = w;
  }
  if (held.count == 0) return held;
  const int n = held.count;
  const Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, 3, 3> product =
      held.columns().transpose() * held.columns();
  held.inverse.topLeftCorner(n, n) = product.inverse();
  return held;
}

/// Pressures of a set's walls from the residual at the node.
std::array<double, most> pressures(const Held& held, const Vec3& left) {
  std::array<double, most> pressure{};
  if (held.count == 0) return pressure;
  const Eigen::Matrix<double, Eigen::Dynamic, 1, 0, 3, 1> found = held.lift().transpose() * left;
  for (int k = 0; k < held.count; ++k) pressure[nth(held.wall, k)] = found[k];
  return pressure;
}

void choose_active(const WallQuestion& question, const WallChoice& solved, WallChoice& choice) {
  const std::array<double, most> pressure = pressures(hold(question, solved.active), question.left);
  for (std::size_t w = 0; w < question.meetings.size(); ++w) {
    const WallMeeting& meeting = question.meetings[w];
    if (question.first)
      choice.active[w] = solved.active[w] || meeting.bilateral || meeting.gap < 0;
    else
      choice.active[w] =
          meeting.bilateral || (solved.active[w] ? pressure[w] : 0.0) - question.stiffness * meeting.gap > 0;
    const bool tied = (meeting.normal - question.tied * meeting.normal).norm() < redundant;
    choice.active[w] = choice.active[w] && !tied;
  }
}

/// The part of a wall's pressure that determines friction, and its derivative by the pressure: a bilateral wall in
/// tension presses the node from the other side.
double pressing(const WallMeeting& meeting, double pressure) {
  return meeting.bilateral ? std::abs(pressure) : std::max(pressure, 0.0);
}
double pressing_slope(const WallMeeting& meeting, double pressure) {
  if (pressure > 0) return 1;
  return meeting.bilateral ? -1 : 0;
}

/// Limit of friction [force].
double capacity(const WallQuestion& question, const Held& held, const WallAction& action) {
  double sum = 0;
  for (int k = 0; k < held.count; ++k) {
    const std::size_t w = nth(held.wall, k);
    sum += question.meetings[w].friction * pressing(question.meetings[w], action.pressure[w]);
  }
  return sum;
}

void add_friction(const WallQuestion& question, const Held& held, WallAction& action) {
  const double spring = sticking_at_walls * question.stiffness, most_friction = capacity(question, held, action);
  const Vec3 trial = held.tangent * (question.friction_before - spring * question.travel);
  const double size = trial.norm();
  action.choice.slides = !question.first && size > most_friction;
  action.friction = trial;
  Mat3 slope = spring * held.slides;
  if (action.choice.slides) {
    const Vec3 direction = trial / size;
    action.friction = most_friction * direction;
    slope = most_friction * spring / size * (held.slides * (held.tangent - direction * direction.transpose()));
    const auto lift = held.lift();
    for (int k = 0; k < held.count; ++k) {
      const WallMeeting& meeting = question.meetings[nth(held.wall, k)];
      const double by_pressure = pressing_slope(meeting, action.pressure[nth(held.wall, k)]);
      action.rows -= meeting.friction * by_pressure * (held.slides * direction) * lift.col(k).transpose();
    }
  }
  action.own += slope;
  action.left -= held.slides * action.friction;
}

}  // namespace

WallAction act(const WallQuestion& question, const WallChoice& solved) {
  WallAction action;
  choose_active(question, solved, action.choice);
  const Held held = hold(question, action.choice.active);
  action.left = held.slides * question.left;
  action.rows = action.free = held.slides;
  if (held.count == 0) return action;
  std::ranges::copy(pressures(held, question.left), action.pressure);
  bool rubs = false;
  for (int k = 0; k < held.count; ++k) rubs = rubs || question.meetings[nth(held.wall, k)].friction > 0;
  if (rubs) add_friction(question, held, action);
  const auto lift = held.lift();
  Eigen::Matrix<double, Eigen::Dynamic, 1, 0, 3, 1> gap(held.count);
  for (int k = 0; k < held.count; ++k) gap[k] = question.meetings[nth(held.wall, k)].gap;
  action.left += question.stiffness * (lift * gap);
  action.own += question.stiffness * (lift * held.normals.leftCols(held.count).transpose());
  return action;
}

}  // namespace brunt::implicit
