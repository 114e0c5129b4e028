// SPDX-License-Identifier: Apache-2.0
#include "mesh/round_bodies.hpp"

#include <Eigen/LU>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

#include "core/cells.hpp"
#include "mesh/assemble.hpp"
#include "outline.hpp"

namespace brunt::mesh {
namespace {

struct Point {
  Vec3 x = Vec3::Zero();
  Mat3 jacobian = Mat3::Zero();
};

Point at(const Mesh& mesh, const LocalIndex* element, const std::array<double, 3>& xi) {
  Point point;
  for (std::size_t k = 0; k < 8; ++k) {
    const Vec3& corner = nth(mesh.coordinates, element[k]);
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

/// Integrals over the height of a body of revolution: of r^2 - i^2, r^3 - i^3 and z (r^2 - i^2), where r is its radius
/// and i that of its bore. Simpson's rule is exact for slices of cones.
struct Slices {
  explicit Slices(double inner) : inner_(inner) {}
  double squares = 0, cubes = 0, heights = 0;

  void add(const std::array<double, 2>& low, const std::array<double, 2>& high) {
    const std::array<double, 2> middle{(low[0] + high[0]) / 2, (low[1] + high[1]) / 2};
    for (const auto& [place, weight] : {std::pair{low, 1.0}, {middle, 4.0}, {high, 1.0}}) {
      const auto [r, z] = place;
      const double height = weight * (high[1] - low[1]) / 6, square = r * r - inner_ * inner_;
      squares += height * square;
      cubes += height * (r * r * r - inner_ * inner_ * inner_);
      heights += height * z * square;
    }
  }

 private:
  double inner_;
};

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
  for (int i = 0; i < 3; ++i) exact.centre[i] = nth(half, i) * 3.0 / 8 * radius;
  return exact;
}

Moments exact_torus(double radius, double inner_radius, double outer_radius) {
  const double section = std::numbers::pi * (outer_radius * outer_radius - inner_radius * inner_radius);
  return {2 * std::numbers::pi * radius * section, Vec3::Zero()};
}

Moments exact_tube(double inner_radius, double outer_radius, double length, const RoundForm& form) {
  const auto& [half, sector, nose] = form;
  const double angle = sector.cuts() ? std::numbers::pi / 180 * (sector.to - sector.from)
                                     : 2 * std::numbers::pi * kept_share({half[0], half[1], 0});
  const auto from = cosine_sine(sector.from), to = cosine_sine(sector.to);
  // of the cosine and of the sine over the angle
  const std::array<double, 2> mean_direction =
      sector.cuts() ? std::array{to[1] - from[1], from[0] - to[0]}
                    : std::array{half[0] * (half[1] != 0 ? 1.0 : 2.0), half[1] * (half[0] != 0 ? 1.0 : 2.0)};
  Slices sum(inner_radius);
  sum.add({outer_radius, 0}, {outer_radius, length});
  if (nose.shape != Nose::Shape::none) {
    const Outline outline(nose, outer_radius, inner_radius);
    constexpr int slices = 4096;
    const auto at = [&](int i) {
      const auto [r, z] = outline.at(i == slices ? 1.0 : static_cast<double>(i) / slices);
      return std::array{r, length + z};
    };
    for (int i = 0; i < slices; ++i) sum.add(at(i), at(i + 1));
  }
  const double volume = angle / 2 * sum.squares;
  const double off = sum.cubes / 3 / volume;
  return {volume, Vec3(mean_direction[0] * off, mean_direction[1] * off, angle / 2 * sum.heights / volume)};
}

}  // namespace brunt::mesh
