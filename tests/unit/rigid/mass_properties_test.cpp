// SPDX-License-Identifier: Apache-2.0
// Mass properties of elements against closed forms and against each other.
#include "rigid/mass_properties.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <catch2/catch.hpp>
#include <random>

using namespace brunt;
using Hex = std::array<Vec3, 8>;

namespace {

Hex brick(const Vec3& at, const Vec3& size) {
  Hex corners;
  constexpr std::array<std::array<int, 3>, 8> place{
      {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}}};
  for (std::size_t k = 0; k < 8; ++k)
    corners[k] = at + Vec3(place[k][0] * size[0], place[k][1] * size[1], place[k][2] * size[2]);
  return corners;
}

void add(rigid::MassMoments& sum, const rigid::MassMoments& part) {
  sum.mass += part.mass;
  sum.first += part.first;
  sum.second += part.second;
}

/// The hexahedron cut at its middle in each parent direction: eight trilinear ones that fill it.
std::vector<Hex> cut(const Hex& whole) {
  const auto at = [&](double u, double v, double w) {
    const Vec3 low = (1 - v) * ((1 - u) * whole[0] + u * whole[1]) + v * ((1 - u) * whole[3] + u * whole[2]);
    const Vec3 high = (1 - v) * ((1 - u) * whole[4] + u * whole[5]) + v * ((1 - u) * whole[7] + u * whole[6]);
    return Vec3((1 - w) * low + w * high);
  };
  std::vector<Hex> parts;
  for (int i = 0; i < 8; ++i) {
    const double u = 0.5 * (i & 1), v = 0.25 * (i & 2), w = 0.125 * (i & 4), h = 0.5;
    parts.push_back({at(u, v, w), at(u + h, v, w), at(u + h, v + h, w), at(u, v + h, w), at(u, v, w + h),
                     at(u + h, v, w + h), at(u + h, v + h, w + h), at(u, v + h, w + h)});
  }
  return parts;
}

}  // namespace

TEST_CASE("a brick has the inertia of a brick, wherever it stands and however it is turned") {
  const Vec3 size(1, 2, 3), middle = Vec3(7, -4, 2) + 0.5 * size;
  Hex corners = brick({7, -4, 2}, size);
  const Mat3 turn = Eigen::AngleAxisd(0.7, Vec3(1, 2, 3).normalized()).toRotationMatrix();
  for (Vec3& corner : corners) corner = turn * corner;
  const auto body = rigid::properties_of(rigid::hexahedron_moments(corners, 5.0));
  CHECK(body.mass == Approx(30).epsilon(1e-14));
  CHECK((body.centre - turn * middle).norm() < 1e-13);
  const Mat3 exact = turn * Vec3(4 + 9, 9 + 1, 1 + 4).asDiagonal() * turn.transpose() * (30.0 / 12);
  CHECK((body.inertia - exact).norm() < 1e-11);
}

TEST_CASE("a distorted hexahedron has the moments of its eight parts, exactly") {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> shift(-0.2, 0.2);
  for (int k = 0; k < 50; ++k) {
    Hex corners = brick({0, 0, 0}, {1, 1, 1});
    for (Vec3& corner : corners) corner += Vec3(shift(random), shift(random), shift(random));
    rigid::MassMoments sum;
    for (const Hex& part : cut(corners)) add(sum, rigid::hexahedron_moments(part, 2.0));
    const rigid::MassMoments whole = rigid::hexahedron_moments(corners, 2.0);
    CHECK(whole.mass == Approx(sum.mass).epsilon(1e-14));
    CHECK((whole.first - sum.first).norm() < 1e-14);
    CHECK((whole.second - sum.second).norm() < 1e-14);
  }
}

TEST_CASE("five tetrahedra make the brick they fill; a wedge is a hexahedron with repeated nodes") {
  const Hex c = brick({1, 2, 3}, {2, 1, 0.5});
  constexpr std::array<std::array<std::size_t, 4>, 5> corners{
      {{0, 1, 3, 4}, {2, 3, 1, 6}, {5, 4, 6, 1}, {7, 6, 4, 3}, {1, 3, 4, 6}}};
  rigid::MassMoments sum;
  for (const auto& t : corners)
    add(sum, rigid::tetrahedron_moments(std::array<Vec3, 4>{c[t[0]], c[t[1]], c[t[2]], c[t[3]]}, 3.0));
  const rigid::MassMoments whole = rigid::hexahedron_moments(c, 3.0);
  CHECK(sum.mass == Approx(whole.mass).epsilon(1e-14));
  CHECK((sum.first - whole.first).norm() < 1e-13);
  CHECK((sum.second - whole.second).norm() < 1e-13);

  const Hex lower{c[0], c[1], c[2], c[2], c[4], c[5], c[6], c[6]},
      upper{c[0], c[2], c[3], c[3], c[4], c[6], c[7], c[7]};
  rigid::MassMoments wedges = rigid::hexahedron_moments(lower, 3.0);
  add(wedges, rigid::hexahedron_moments(upper, 3.0));
  CHECK(wedges.mass == Approx(whole.mass).epsilon(1e-14));
  CHECK((wedges.second - whole.second).norm() < 1e-13);
}

TEST_CASE("moments survive their way through plain numbers") {
  const rigid::MassMoments sent = rigid::hexahedron_moments(brick({1, 2, 3}, {2, 1, 0.5}), 3.0);
  const rigid::MassMoments come = rigid::MassMoments::from(sent.values());
  CHECK(come.mass == sent.mass);
  CHECK(come.first == sent.first);
  CHECK((come.second - sent.second).norm() < 1e-14);  // of two equal places one is sent
}
