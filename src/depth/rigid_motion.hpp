// SPDX-License-Identifier: Apache-2.0
// Rigid motions of body A from its given placement: a rotation about the centroid and the displacement of the centroid.
//
// All vectors are in the axes of A at the given placement q_0, lengths from its centroid c. With the unit quaternion
// (w, v), w = cos(phi/2) >= 0, v = sin(phi/2) u, a point y = x - c moves by
//   d(y) = T + (R - I) y,   (R - I) y = 2 (w v x y + v x (v x y)).
// Screw (Chasles): slide h = T . u along the axis u through p = (P + cot(phi/2) u x P)/2, P = T - h u. At the fraction
// s of the screw the rotation is s phi and the displacement of the centroid is
//   T(s) = s h u + sin(s phi/2)/sin(phi/2) (cos((1-s) phi/2) P - sin((1-s) phi/2) u x P),
// which has no singularity for phi in [0, pi] (derived here; p itself goes to infinity with phi -> 0).
#pragma once
#include <Eigen/Geometry>

#include "core/triangle_surface.hpp"

namespace brunt::depth {

/// Without the alignment of vector registers, which buffers of std::stable_sort do not have (libstdc++ 12).
using Turn = Eigen::Quaternion<double, Eigen::DontAlign>;

struct RigidMotion {
  Turn turn = Turn::Identity();  ///< unit
  Vec3 shift = Vec3::Zero();     ///< T, displacement of the centroid [length]
};

/// Rotation by |w| about w.
[[nodiscard]] Eigen::Quaterniond rotation_of(const Vec3& w);

/// The inverse, with |w| in [0, pi]; exact to rounding near 0 and near pi. At pi the sign of w is that of v.
[[nodiscard]] Vec3 rotation_vector(const Eigen::Quaterniond& turn);

/// R - I, each entry with the relative accuracy of rounding for any size of the rotation.
[[nodiscard]] Mat3 rotation_less_identity(const Eigen::Quaterniond& turn);

/// From `from` to `to`, of a body with this centroid (coordinates of its file).
[[nodiscard]] RigidMotion motion_between(const Placement& from, const Placement& to, const Vec3& centroid);

/// The placement after the motion of a body at `from`.
[[nodiscard]] Placement moved(const Placement& from, const RigidMotion& motion, const Vec3& centroid);

/// First `first`, then `second`, which is given in the axes of the same q_0 and rotates about the moved centroid.
[[nodiscard]] RigidMotion compose(const RigidMotion& first, const RigidMotion& second);

/// A screw motion.
struct Screw {
  Vec3 axis = Vec3::UnitX();  ///< u
  Vec3 point = Vec3::Zero();  ///< p, the point of the axis nearest to the centroid; zero without rotation [length]
  double angle = 0;           ///< phi, in [0, pi] [rad]
  double slide = 0;           ///< h [length]
};

/// Without rotation the axis is the direction of T. Rotations below 1e-150 count as zero.
[[nodiscard]] Screw screw_of(const RigidMotion& motion);

/// The part s in [0, 1] of the screw from q_0 to the motion. The displacements of all points increase with s.
[[nodiscard]] RigidMotion along_screw(const RigidMotion& motion, double s);

}  // namespace brunt::depth
