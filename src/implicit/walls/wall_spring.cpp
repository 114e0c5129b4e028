// SPDX-License-Identifier: Apache-2.0
#include "implicit/walls/wall_spring.hpp"

#include <cmath>

namespace brunt::implicit {
namespace {

/// Limit of friction, its derivative by the node's position, and the directions free of active walls.
struct Friction {
  double most = 0;  ///< [force]
  Vec3 slope = Vec3::Zero();
  Mat3 along = Mat3::Identity();
  bool rubs = false;
};

void take_out(const Vec3& normal, Mat3& along) {
  constexpr double redundant = 1e-6;  // as for other nodes at walls
  const Vec3 rest = along * normal;
  if (rest.norm() < redundant) return;
  const Vec3 unit = rest.normalized();
  along -= unit * unit.transpose();
}

void add_friction(const WallQuestion& question, const Friction& friction, WallAction& action) {
  const double stiffness = question.stiffness;  // a higher stiffness than along the normal would oscillate for longer
  const Vec3 trial = friction.along * (question.friction_before - stiffness * question.travel);
  const double size = trial.norm();
  action.friction = trial;
  action.choice.slides = !question.first && size > friction.most;
  Mat3 slope = stiffness * friction.along;
  if (action.choice.slides) {
    const Vec3 direction = trial / size;
    action.friction = friction.most * direction;
    action.by_pressure = -direction * friction.slope.transpose();
    slope =
        friction.most * stiffness / size * (friction.along - direction * direction.transpose()) + action.by_pressure;
  }
  action.left -= action.friction;
  action.own += slope;
}

}  // namespace

WallAction spring(const WallQuestion& question, const WallChoice& solved) {
  WallAction action;
  action.left = question.left;
  Friction friction;
  for (std::size_t w = 0; w < question.meetings.size(); ++w) {
    const WallMeeting& meeting = question.meetings[w];
    const double pressure = -question.stiffness * meeting.gap;
    action.choice.active[w] = meeting.bilateral || pressure > 0 || (question.first && solved.active[w]);
    if (!action.choice.active[w]) continue;
    action.pressure[w] = pressure;
    action.left -= pressure * meeting.normal;
    action.own += question.stiffness * meeting.normal * meeting.normal.transpose();
    friction.most += meeting.friction * std::abs(pressure);
    friction.slope -= std::copysign(meeting.friction * question.stiffness, pressure) * meeting.normal;
    friction.rubs = friction.rubs || meeting.friction > 0;
    take_out(meeting.normal, friction.along);
  }
  if (friction.rubs) add_friction(question, friction, action);
  return action;
}

}  // namespace brunt::implicit
