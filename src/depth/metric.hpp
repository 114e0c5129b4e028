// SPDX-License-Identifier: Apache-2.0
// The length of a rigid motion of a body: the metrics of generalized penetration depth.
//
//   translation  |T|, of motions without rotation
//   displacement DISP = max over points of |d(y)|. d is affine in y, so a vertex of the convex hull attains it
//   object norm  rms = sqrt(sigma), sigma = (1/m) integral rho |d|^2 dV = |T|^2 + 4 v^T J v, J = inertia/mass
// All are lengths, and rms <= DISP <= ratio rms with ratio^2 = 1 + max over vertices of lambda_max([p]x J^-1 [p]x^T).
// L. Zhang, Y. J. Kim, D. Manocha, IROS 2007 (both metrics); the form of sigma without principal axes and the ratio are
// derived in the README of this room.
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "core/aligned.hpp"
#include "depth/rigid_motion.hpp"
#include "rigid/mass_properties.hpp"

namespace brunt::depth {

enum class Metric : std::int8_t { translation, displacement, object_norm };

/// Properties of a body for the metrics. Lengths are measured from its centroid, in the axes of its file.
struct MetricShape {
  Vec3 centroid = Vec3::Zero();         ///< in the coordinates of the file [length]
  Mat3 gyration = Mat3::Zero();         ///< J [length^2]
  std::vector<Vec3> extremes;           ///< all vertices of the convex hull, perhaps some more
  AlignedVector<double> components[3];  ///< of the extremes, padded to a multiple of eight by the last one
  double radius = 0;                    ///< of the farthest vertex [length]
  double turn_length = 0;  ///< sqrt(tr J / 2): rotations times this length are comparable with displacements [length]
  double ratio = 0;        ///< c: DISP <= c rms
};

/// mass: of the body with these points, positive and not flat.
[[nodiscard]] MetricShape metric_shape(std::span<const Vec3> points, const rigid::MassProperties& mass);

/// 1 + lambda_max([y]x J^-1 [y]x^T): |d(y)|^2 is at most this times sigma, with equality for some small motion.
[[nodiscard]] double point_factor(const Mat3& gyration, const Vec3& y);

/// DISP [length] and the extreme vertex that moves most (the first of equals).
struct Farthest {
  double distance = 0;
  std::size_t vertex = 0;
};
[[nodiscard]] Farthest farthest(const MetricShape& shape, const RigidMotion& motion);
/// The same of the affine displacement T + D y.
[[nodiscard]] Farthest farthest(const MetricShape& shape, const Mat3& D, const Vec3& T);

/// [length]. `translation` ignores the rotation.
[[nodiscard]] double length_of(const MetricShape& shape, Metric metric, const RigidMotion& motion);

}  // namespace brunt::depth
