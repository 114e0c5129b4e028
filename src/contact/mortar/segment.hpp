// SPDX-License-Identifier: Apache-2.0
// Mortar integrals over the overlap of one slave and one master facet, and their derivatives. Facets are triangles or
// bilinear quadrilaterals; their corners run counter-clockwise seen from outside (src/contact/mortar/README.md).
#pragma once
#include <array>
#include <span>

#include "core/types.hpp"
#include "geometry/clip.hpp"

namespace brunt::contact {

/// Corners of one facet, three or four [length].
using FacetCorners = std::span<const Vec3>;

/// Facets whose unit normals have a larger scalar product than this do not face each other and have no segment.
constexpr double opposing_normals = -0.2;

/// Overlaps below this share of the slave facet have no segment.
constexpr double least_overlap = 1e-9;

/// The integration plane of the segments of a slave facet: through its centre, perpendicular to the normal of its two
/// diagonals (for a triangle: of its edges).
struct SlavePlane {
  int corners = 0;
  Vec3 centre = Vec3::Zero(), normal = Vec3::Zero(), first = Vec3::Zero(), second = Vec3::Zero();  ///< axes: unit
  std::array<Vec3, 2> diagonal{Vec3::Zero(), Vec3::Zero()};  ///< their cross product points along the normal
  double twice_area = 0;                                     ///< length of that product [length^2]
  std::array<geometry::PlanePoint<double>, 4> point{};       ///< corners in the plane [length]
  std::array<double, 4> height{};                            ///< of the corners along the normal [length]

  [[nodiscard]] double area() const { return 0.5 * twice_area; }
};

/// Returns false if the facet has no area, or a value is not finite.
bool make_slave_plane(FacetCorners slave, SlavePlane& plane);

/// False for most facets of which integrate_segment would find nothing: they do not face the slave, or the bounds of
/// both in the plane do not overlap.
bool may_share_segment(const SlavePlane& plane, FacetCorners master);

/// A, B: corners of the slave facet; C: of the master facet. Entries of absent corners are 0. All [length^2].
struct SegmentIntegrals {
  double area = 0;                                ///< of the overlap, on the plane
  double distance = 0;                            ///< mean of master minus slave along the slave's normal [length]
  std::array<double, 4> share{};                  ///< int N_A
  std::array<std::array<double, 4>, 4> slave{};   ///< int N_A N_B
  std::array<std::array<double, 4>, 4> master{};  ///< int N_A N_C
};

/// Derivatives by the 24 coordinates of the corners: 3 corner + axis, the slave's corners 0 to 3 first, then the
/// master's from 12 on. [length]
struct SegmentSlopes {
  static constexpr int directions = 24;
  using Slopes = std::array<double, directions>;
  std::array<Slopes, 10> slave{};                 ///< of int N_A N_B, A <= B: see `pair_of_corners`
  std::array<std::array<Slopes, 4>, 4> master{};  ///< of int N_A N_C

  /// Position of the pair (a, b) of slave corners in `slave`.
  static constexpr std::size_t pair_of_corners(std::size_t a, std::size_t b) {
    const std::size_t low = a < b ? a : b, high = a < b ? b : a;
    return low * 4 - low * (low + 1) / 2 + high;
  }
};

/// The segment of a pair, with derivatives if `slopes` is given. Returns false if there is none. capture: largest mean
/// distance along the normal, in both directions [length].
bool integrate_segment(const SlavePlane& plane, FacetCorners master, double capture, SegmentIntegrals& integrals,
                       SegmentSlopes* slopes = nullptr);

}  // namespace brunt::contact
