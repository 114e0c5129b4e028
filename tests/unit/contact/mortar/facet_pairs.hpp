// SPDX-License-Identifier: Apache-2.0
// Pairs of facets that the tests of mortar integrals share.
#pragma once
#include <array>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include "contact/mortar/segment.hpp"
#include "core/types.hpp"

namespace brunt::test {

using Corners = std::vector<Vec3>;

inline const Corners unit_square{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};

/// The master of M1 in reference-mortar.md: a unit square turned by 30 degrees about z, centre (.8, .6, .1), looking
/// down.
inline Corners turned_square() {
  const double c = std::cos(std::numbers::pi / 6), s = std::sin(std::numbers::pi / 6);
  Corners corners;
  for (const auto& [x, y] : {std::pair{-.5, -.5}, std::pair{-.5, .5}, std::pair{.5, .5}, std::pair{.5, -.5}})
    corners.emplace_back(.8 + c * x - s * y, .6 + s * x + c * y, .1);
  return corners;
}

/// All products of a pair: sixteen of two slave functions, sixteen of slave and master.
inline std::array<double, 32> products_of(const contact::SegmentIntegrals& integrals) {
  std::array<double, 32> all{};
  for (std::size_t a = 0; a < 4; ++a)
    for (std::size_t b = 0; b < 4; ++b) {
      all[4 * a + b] = integrals.slave[a][b];
      all[16 + 4 * a + b] = integrals.master[a][b];
    }
  return all;
}

struct FacetPair {
  Corners slave, master;
};

/// A slave facet that looks up and a master facet above it that looks down, warped and askew, anywhere in space.
class RandomPairs {
 public:
  explicit RandomPairs(unsigned seed) : random_(seed) {}

  FacetPair operator()(int slave_corners, int master_corners, double shift = 0.15) {
    const Corners triangle{{0, 0, 0}, {1.2, 0, 0}, {0, 1.2, 0}};
    FacetPair pair{slave_corners == 3 ? triangle : unit_square, master_corners == 3 ? triangle : unit_square};
    std::swap(pair.master[1], pair.master[pair.master.size() - 1]);
    const double angle = std::numbers::pi * number_(random_);
    for (Vec3& x : pair.master)
      x = Vec3(std::cos(angle) * (x[0] - .5) - std::sin(angle) * (x[1] - .5) + .5 + .4 * number_(random_),
               std::sin(angle) * (x[0] - .5) + std::cos(angle) * (x[1] - .5) + .5, .1);
    const Mat3 turn = rotation();
    for (Corners* corners : {&pair.slave, &pair.master})
      for (Vec3& x : *corners) x = turn * (x + shift * Vec3(number_(random_), number_(random_), number_(random_)));
    return pair;
  }

 private:
  Mat3 rotation() {
    Mat3 turn = Mat3::Identity();
    for (int axis = 0; axis < 3; ++axis) {
      const double angle = std::numbers::pi * number_(random_);
      const int i = (axis + 1) % 3, j = (axis + 2) % 3;
      Mat3 about = Mat3::Identity();
      about(i, i) = about(j, j) = std::cos(angle);
      about(j, i) = std::sin(angle);
      about(i, j) = -about(j, i);
      turn = about * turn;
    }
    return turn;
  }

  std::mt19937 random_;
  std::uniform_real_distribution<double> number_{-1, 1};
};

}  // namespace brunt::test
