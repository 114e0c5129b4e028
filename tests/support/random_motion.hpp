// SPDX-License-Identifier: Apache-2.0
// Random directions, rotations and placements for tests.
#pragma once
#include <Eigen/Geometry>
#include <random>

#include "core/triangle_surface.hpp"

namespace brunt::test {

class Random {
 public:
  explicit Random(unsigned long seed) : engine_(seed) {}
  /// in [0, 1)
  double uniform() { return static_cast<double>(engine_() >> 11U) * 0x1p-53; }
  double uniform(double low, double high) { return low + (high - low) * uniform(); }
  int below(int n) { return static_cast<int>(engine_() % static_cast<unsigned>(n)); }
  double normal() { return normal_(engine_); }
  Vec3 vector() {
    const double x = normal(), y = normal(), z = normal();
    return {x, y, z};
  }
  Vec3 direction() { return vector().normalized(); }
  /// Uniform over all rotations.
  Eigen::Quaterniond rotation() {
    const double w = normal();
    const Vec3 v = vector();
    return Eigen::Quaterniond(w, v[0], v[1], v[2]).normalized();
  }
  Placement placement(double size = 1) {
    const Mat3 turn = rotation().toRotationMatrix();
    return {turn, size * vector()};
  }

 private:
  std::mt19937_64 engine_;
  std::normal_distribution<double> normal_;
};

}  // namespace brunt::test
