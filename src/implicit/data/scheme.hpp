// SPDX-License-Identifier: Apache-2.0
// Coefficients of the time integration schemes. With F = loads - internal forces, F^c of contact and F^s of supports, a
// step solves
//
//   m M (u_{n+1} - u*) = now F_{n+1} + before F_n + F^c + F^s
//
// for u_{n+1}; M is the lumped mass.
//   statics            m = 0, now = 1, before = 0
//   newmark, hht       m = 1/(beta dt^2), u* = u_n + dt v_n + dt^2 (1/2 - beta) a_n, now = 1 - alpha, before = alpha,
//                      beta = (1 + alpha)^2 / 4, gamma = 1/2 + alpha (Hilber, Hughes and Taylor 1977; newmark: alpha 0)
//   contact_implicit   m = 2/dt^2, u* = u_n + dt v_n, now = before = 1/2: the trapezoidal rule with the whole force of
//                      contact and supports taken at t_{n+1} (Kane, Repetto, Ortiz and Marsden 1999)
#pragma once
#include "core/types.hpp"
#include "model/implicit_solver.hpp"

namespace brunt::implicit {

struct Rule {
  double mass = 0;  ///< m [1/time^2]
  double now = 1, before = 0;
  double dt = 0;               ///< [time]
  double beta = 0, gamma = 0;  ///< of newmark and hht, otherwise 0
};

Rule rule_of(const model::ImplicitSolver& solver, double dt);

/// Displacement of a node without forces: u* - u_n [length].
Vec3 free_travel(const Rule& rule, const Vec3& velocity, const Vec3& acceleration);

/// Velocity and acceleration at t_{n+1} from `travel` = u_{n+1} - u_n. `acceleration` is advanced from t_n to t_{n+1};
/// schemes without it (beta = 0) leave it unchanged.
Vec3 velocity_after(const Rule& rule, const Vec3& travel, const Vec3& velocity, Vec3& acceleration);

}  // namespace brunt::implicit
