// SPDX-License-Identifier: Apache-2.0
// Mass, centre and inertia of a rigid body from the exact integrals of its elements.
#pragma once
#include <array>
#include <span>

#include "core/types.hpp"

namespace brunt::rigid {

/// Integrals of density times 1, x and x x^T over a volume, with x measured from a common point. Values of elements are
/// added.
struct MassMoments {
  double mass = 0;             ///< [mass]
  Vec3 first = Vec3::Zero();   ///< [mass length]
  Mat3 second = Mat3::Zero();  ///< symmetric [mass length^2]
  static constexpr int width = 10;
  /// mass; first; second as xx, yy, zz, xy, yz, zx: for sums over ranks.
  [[nodiscard]] std::array<double, width> values() const;
  [[nodiscard]] static MassMoments from(std::span<const double, width> values);
  friend MassMoments operator+(const MassMoments& a, const MassMoments& b) {
    return {a.mass + b.mass, a.first + b.first, a.second + b.second};
  }
};

/// Of the trilinear hexahedron (corners in the order of core/cells.hpp, also degenerate ones). Exact: the integrand
/// is of fourth degree in each parent coordinate at most, and three Gauss points integrate fifth degree.
[[nodiscard]] MassMoments hexahedron_moments(std::span<const Vec3, 8> corners, double density);

/// Of the tetrahedron with flat faces, exact.
[[nodiscard]] MassMoments tetrahedron_moments(std::span<const Vec3, 4> corners, double density);

/// Of a shell between flat triangles, four around the centre of a quadrilateral: corners counter-clockwise seen from
/// its top, middle at offset * thickness along the normal. Exact for flat shells.
[[nodiscard]] MassMoments shell_moments(std::span<const Vec3> corners, double thickness, double offset, double density);

/// The inertial properties of a rigid body in its reference position.
struct MassProperties {
  double mass = 0;
  Vec3 centre = Vec3::Zero();   ///< of mass, from the point that the moments were measured from [length]
  Mat3 inertia = Mat3::Zero();  ///< about the centre, in the axes of the reference position [mass length^2]
};

/// Of a body with these moments. The mass must be positive.
[[nodiscard]] MassProperties properties_of(const MassMoments& moments);

/// The inverse, about the same point from which the centre is measured.
[[nodiscard]] MassMoments moments_of(const MassProperties& properties);

}  // namespace brunt::rigid
