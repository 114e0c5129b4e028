// SPDX-License-Identifier: Apache-2.0
#include "rigid/mass_properties.hpp"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <cmath>

#include "core/cells.hpp"

namespace brunt::rigid {
namespace {

struct GaussPoint {
  double at, weight;
};
const std::array<GaussPoint, 3> gauss{{{-std::sqrt(0.6), 5.0 / 9}, {0.0, 8.0 / 9}, {std::sqrt(0.6), 5.0 / 9}}};

/// Position at a point of the parent cube, and the determinant of its derivative there.
struct HexMap {
  Vec3 x = Vec3::Zero();
  double determinant = 0;
  HexMap(std::span<const Vec3, 8> corners, const Vec3& parent) {
    Mat3 derivative = Mat3::Zero();
    for (std::size_t k = 0; k < 8; ++k) {
      Vec3 factor, sign;
      for (int i = 0; i < 3; ++i) {
        sign[i] = nth(cells::hex_corners[k], i);
        factor[i] = 0.5 * (1 + sign[i] * parent[i]);
      }
      x += factor[0] * factor[1] * factor[2] * corners[k];
      for (int i = 0; i < 3; ++i)
        derivative.col(i) += 0.5 * sign[i] * factor[(i + 1) % 3] * factor[(i + 2) % 3] * corners[k];
    }
    determinant = derivative.determinant();
  }
};

}  // namespace

std::array<double, MassMoments::width> MassMoments::values() const {
  return {mass,         first[0],     first[1],     first[2],     second(0, 0),
          second(1, 1), second(2, 2), second(0, 1), second(1, 2), second(2, 0)};
}

MassMoments MassMoments::from(std::span<const double, width> v) {
  MassMoments moments{v[0], {v[1], v[2], v[3]}, {}};
  moments.second << v[4], v[7], v[9],  //
      v[7], v[5], v[8],                //
      v[9], v[8], v[6];
  return moments;
}

MassMoments hexahedron_moments(std::span<const Vec3, 8> corners, double density) {
  MassMoments moments;
  for (const GaussPoint& p : gauss)
    for (const GaussPoint& q : gauss)
      for (const GaussPoint& r : gauss) {
        const HexMap map(corners, {p.at, q.at, r.at});
        const double mass = density * p.weight * q.weight * r.weight * map.determinant;
        moments.mass += mass;
        moments.first += mass * map.x;
        moments.second += mass * map.x * map.x.transpose();
      }
  return moments;
}

MassMoments tetrahedron_moments(std::span<const Vec3, 4> corners, double density) {
  const Vec3 a = corners[1] - corners[0], b = corners[2] - corners[0], c = corners[3] - corners[0];
  const double mass = density * a.dot(b.cross(c)) / 6;
  Vec3 sum = Vec3::Zero();
  Mat3 squares = Mat3::Zero();
  for (const Vec3& x : corners) {
    sum += x;
    squares += x * x.transpose();
  }
  // the integral of a product of two barycentric coordinates is V/20, and V/10 where they are the same
  return {mass, 0.25 * mass * sum, mass / 20 * (squares + sum * sum.transpose())};
}

namespace {

/// Of a flat triangle with its mass spread over a thickness about its middle.
MassMoments triangle_moments(const Vec3& a, const Vec3& b, const Vec3& c, double thickness, double offset,
                             double density) {
  const Vec3 twice_area = (b - a).cross(c - a);
  const double size = twice_area.norm();
  if (!(size > 0)) return {};
  const Vec3 normal = twice_area / size, shift = offset * thickness * normal;
  const double mass = 0.5 * size * thickness * density;
  MassMoments moments{mass, mass * ((a + b + c) / 3 + shift)};
  for (const Vec3& middle : {Vec3(0.5 * (a + b)), Vec3(0.5 * (b + c)), Vec3(0.5 * (c + a))}) {  // exact to degree 2
    const Vec3 x = middle + shift;
    moments.second += mass / 3 * x * x.transpose();
  }
  moments.second += mass * thickness * thickness / 12 * normal * normal.transpose();
  return moments;
}

}  // namespace

MassMoments shell_moments(std::span<const Vec3> corners, double thickness, double offset, double density) {
  if (corners.size() == 3) return triangle_moments(corners[0], corners[1], corners[2], thickness, offset, density);
  const Vec3 centre = 0.25 * (corners[0] + corners[1] + corners[2] + corners[3]);
  MassMoments sum;
  for (std::size_t k = 0; k < 4; ++k)
    sum = sum + triangle_moments(corners[k], corners[(k + 1) % 4], centre, thickness, offset, density);
  return sum;
}

MassProperties properties_of(const MassMoments& moments) {
  const Vec3 centre = moments.first / moments.mass;
  const Mat3 second = moments.second - moments.mass * centre * centre.transpose();
  return {moments.mass, centre, second.trace() * Mat3::Identity() - second};
}

MassMoments moments_of(const MassProperties& properties) {
  const auto& [mass, centre, inertia] = properties;
  const Mat3 about_centre = 0.5 * inertia.trace() * Mat3::Identity() - inertia;
  return {mass, mass * centre, about_centre + mass * centre * centre.transpose()};
}

}  // namespace brunt::rigid
