// SPDX-License-Identifier: Apache-2.0
#include "implicit/data/scheme.hpp"

namespace brunt::implicit {

using model::Scheme;

Rule rule_of(const model::ImplicitSolver& solver, double dt) {
  switch (solver.scheme) {
    case Scheme::statics:
      return {.dt = dt};
    case Scheme::contact_implicit:
      return {.mass = 2 / (dt * dt), .now = 0.5, .before = 0.5, .dt = dt};
    case Scheme::hht:
    case Scheme::newmark:
      break;
  }
  const double alpha = solver.scheme == Scheme::hht ? solver.alpha : 0.0;
  const double beta = 0.25 * (1 + alpha) * (1 + alpha);
  return {1 / (beta * dt * dt), 1 - alpha, alpha, dt, beta, 0.5 + alpha};
}

Vec3 free_travel(const Rule& rule, const Vec3& velocity, const Vec3& acceleration) {
  if (rule.mass == 0) return Vec3::Zero();
  const Vec3 straight = rule.dt * velocity;
  return rule.beta == 0 ? straight : Vec3(straight + rule.dt * rule.dt * (0.5 - rule.beta) * acceleration);
}

Vec3 velocity_after(const Rule& rule, const Vec3& travel, const Vec3& velocity, Vec3& acceleration) {
  if (rule.mass == 0) return travel / rule.dt;
  if (rule.beta == 0) return 2 / rule.dt * travel - velocity;
  const Vec3 before = acceleration;
  acceleration = rule.mass * (travel - free_travel(rule, velocity, before));
  return velocity + rule.dt * ((1 - rule.gamma) * before + rule.gamma * acceleration);
}

}  // namespace brunt::implicit
