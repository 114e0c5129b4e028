// SPDX-License-Identifier: Apache-2.0
#include "brunt/mesh/round_bodies.hpp"

#include <Eigen/LU>
#include <array>
#include <cmath>
#include <numbers>

#include "brunt/core/cells.hpp"

namespace brunt::mesh {
namespace {

struct Point {
  Vec3 x = Vec3::Zero();
  Mat3 jacobian = Mat3::Zero();
};

Point at(const Mesh& mesh, const LocalIndex* element, const std::array<double, 3>& xi) {
  Point point;
  for (std::size_t k = 0; k < 8; ++k) {
    const Vec3& corner = mesh.coordinates[static_cast<std::size_t>(element[k])];
    std::array<double, 3> factor{};
    for (std::size_t i = 0; i < 3; ++i) factor[i] = 0.5 * (1 + cells::hex_corners[k][i] * xi[i]);
    point.x += factor[0] * factor[1] * factor[2] * corner;
    for (int i = 0; i < 3; ++i) {
      const auto a = static_cast<std::size_t>(i), b = (a + 1) % 3, c = (a + 2) % 3;
      point.jacobian.col(i) += 0.5 * cells::hex_corners[k][a] * factor[b] * factor[c] * corner;
    }
  }
  return point;
}

double kept_share(const Half& half) {
  double share = 1;
  for (const int kept : half) share *= kept == 0 ? 1.0 : 0.5;
  return share;
}

}  // namespace

Moments moments(const Mesh& mesh) {
  Moments sum;
  const double gauss = std::numbers::inv_sqrt3;
  for (const Block& block : mesh.blocks)
    for (LocalIndex e = 0; e < block.count(); ++e)
      for (const auto& signs : cells::hex_corners) {
        const Point point = at(mesh, block.element(e), {gauss * signs[0], gauss * signs[1], gauss * signs[2]});
        const double volume = point.jacobian.determinant();
        sum.volume += volume;
        sum.centre += volume * point.x;
      }
  sum.centre /= sum.volume;
  return sum;
}

Moments exact_sphere(double radius, const Half& half) {
  Moments exact{kept_share(half) * 4.0 / 3 * std::numbers::pi * radius * radius * radius, Vec3::Zero()};
  for (int i = 0; i < 3; ++i) exact.centre[i] = half[static_cast<std::size_t>(i)] * 3.0 / 8 * radius;
  return exact;
}

Moments exact_tube(double inner_radius, double outer_radius, double length, const Half& half) {
  const double i2 = inner_radius * inner_radius, o2 = outer_radius * outer_radius;
  const double offset = 4 / (3 * std::numbers::pi) * (o2 * outer_radius - i2 * inner_radius) / (o2 - i2);
  return {kept_share(half) * std::numbers::pi * (o2 - i2) * length,
          Vec3(half[0] * offset, half[1] * offset, length / 2)};
}

}  // namespace brunt::mesh
