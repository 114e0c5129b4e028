// SPDX-License-Identifier: Apache-2.0
// The map of a square (cube) grid into a disk (ball): a rounded core, then straight lines out to the circle (sphere).
#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "brunt/core/types.hpp"

namespace brunt::mesh {

/// Core cells (i, j, l) lie in |i|, |j|, |l| <= half_cells; l = 0 for a disk. The core is a blend of a cube and a ball:
/// the ball's share opens the right angles at the cube's edges, where three elements meet. The core's size and share
/// were chosen by a scan for the best product of smallest scaled Jacobian and smallest edge (disk: 0.85, 0.75 R/n).
class RoundedCore {
 public:
  RoundedCore(double radius, int elements)
      : radius_(radius),
        elements_(elements),
        half_cells_(std::clamp(static_cast<int>(std::lround(0.6 * elements)), 1, elements - 1)) {}

  [[nodiscard]] int half_cells() const { return half_cells_; }

  [[nodiscard]] Vec3 inside(const std::array<int, 3>& cell) const {
    const int layer = std::max({std::abs(cell[0]), std::abs(cell[1]), std::abs(cell[2])});
    if (layer == 0) return Vec3::Zero();
    const double step = 0.92 * radius_ / elements_, ball_share = 0.4;
    const Vec3 cube(cell[0], cell[1], cell[2]);
    return step * ((1 - ball_share) * cube + ball_share * layer * direction(cell, layer));
  }

  /// `shell` 0 is the core's surface, elements - half_cells the circle or sphere; `cell` lies on the core's surface.
  [[nodiscard]] Vec3 outside(const std::array<int, 3>& cell, int shell) const {
    const int shells = elements_ - half_cells_;
    Vec3 outer = radius_ * direction(cell, half_cells_);
    if (shell == shells) return outer;
    const Vec3 inner = inside(cell);
    return inner + (outer - inner) * shell / shells;
  }

 private:
  /// Equal angles between neighbours along each axis.
  static Vec3 direction(const std::array<int, 3>& cell, int layer) {
    const auto slope = [layer](int i) {
      return std::abs(i) == layer ? std::copysign(1.0, i) : std::tan(std::numbers::pi / 4 * i / layer);
    };
    return Vec3(slope(cell[0]), slope(cell[1]), slope(cell[2])).normalized();
  }

  double radius_;
  int elements_, half_cells_;
};

}  // namespace brunt::mesh
