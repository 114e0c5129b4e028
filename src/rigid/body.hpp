// SPDX-License-Identifier: Apache-2.0
// A rigid body: six degrees of freedom, and an integrator that conserves momentum, angular momentum and the energy of a
// free body up to rounding.
//
// State at t_n: displacement of the centre, orientation R_n (X -> R_n X about the centre), momentum and angular
// momentum about the centre at the half step. Forces at t_n change both at once, as they do velocities of nodes:
//   l <- l + dt_mean tau_n,   omega = I_n^-1 l,   I_n = R_n J R_n^T.
// Over the step l is constant in space, and the body turns by the implicit midpoint rule of Euler's equations,
//   M = (P_n + P_{n+1})/2,  P_{n+1} - P_n = dt M x J^-1 M,  R_{n+1} = R_n cay(dt J^-1 M),  P = R^T l:
// second order in dt, and P_{n+1} . J^-1 P_{n+1} = P_n . J^-1 P_n, R_{n+1} P_{n+1} = R_n P_n = l. Impulses that do the
// work impulse . (velocity before + velocity after)/2, with velocities by I_n, are therefore the only cause of changes
// of the energy.
// M. A. Austin, P. S. Krishnaprasad, L. S. Wang, J. Comput. Phys. 107 (1993) 105-117 (section on the mid-point rule).
#pragma once
#include <Eigen/Geometry>

#include "core/types.hpp"
#include "rigid/mass_properties.hpp"

namespace brunt::rigid {

/// Constant in a run.
struct Body {
  MassProperties mass;
  Mat3 inverse_inertia = Mat3::Zero();  ///< J^-1 [1/(mass length^2)]; zero along axes without inertia
};

/// The inverse treats axes whose moment is below 1e-12 of the largest one (a single node, nodes on a line) as axes
/// about which nothing can rotate the body: contact on the axis itself has no lever arm.
[[nodiscard]] Body make_body(const MassProperties& mass);

struct BodyState {
  Vec3 displacement = Vec3::Zero();  ///< of the centre [length]
  Eigen::Quaterniond orientation = Eigen::Quaterniond::Identity();
  Vec3 velocity = Vec3::Zero();          ///< of the centre, at the half step [velocity]
  Vec3 angular_momentum = Vec3::Zero();  ///< about the centre, at the half step [mass length^2/time]
};

/// I_n^-1 in space.
[[nodiscard]] Mat3 inverse_inertia_now(const Body& body, const BodyState& state);

/// [rad/time], of the angular momentum in the configuration of t_n.
[[nodiscard]] Vec3 angular_velocity(const Body& body, const BodyState& state);

/// Of a given angular velocity: I_n omega.
[[nodiscard]] Vec3 angular_momentum_of(const Body& body, const BodyState& state, const Vec3& angular_velocity);

/// 1/2 m v^2 + 1/2 l . I_n^-1 l [energy].
[[nodiscard]] double kinetic_energy(const Body& body, const BodyState& state);

/// Advances to t_n + dt without forces.
void move(const Body& body, double dt, BodyState& state);

}  // namespace brunt::rigid
