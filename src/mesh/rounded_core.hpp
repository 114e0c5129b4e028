// SPDX-License-Identifier: Apache-2.0
// The map of a square (cube) grid into a disk (ball): a rounded core, then straight lines out to the circle (sphere).
#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "core/types.hpp"

namespace brunt::mesh {

/// Core cells (i, j, l) lie in |i|, |j|, |l| <= half_cells; l = 0 for a disk. The core is a blend of a cube and a ball:
/// the share of the ball widens the right angles at the edges of the cube, where three elements meet. Size and share of
/// the core are the result of a scan for the largest product of smallest scaled Jacobian and smallest edge (disk: 0.85,
/// 0.75 R/n).
///
/// Elements across the radius may be uneven. The first `round_from` of them are what an even body of that many would
/// be, with its lines moved; beyond, shells are circles (spheres).
class RoundedCore {
 public:
  static constexpr double usual_width = 0.92;  ///< of a core cell, in elements across the radius

  RoundedCore(double radius, int elements) : RoundedCore(even(radius, elements), elements) {}

  /// `places`: from 0 to the radius; 1 <= round_from < their number.
  RoundedCore(std::vector<double> places, int round_from, double width = usual_width)
      : places_(std::move(places)),
        width_(width),
        round_from_(round_from),
        half_cells_(half_cells_of(places_, round_from)) {
    const double radius = nth(places_, round_from);
    for (int i = 0; i <= round_from; ++i) {
      const double even_place = radius * i / round_from, place = nth(places_, i);
      level_.push_back(place == even_place ? i : place / radius * round_from);
    }
  }

  /// The core ends at the place nearest to 0.6 of the first circle's radius: uneven elements must leave its corners,
  /// which reach 1.25 times as far, within that circle.
  [[nodiscard]] static int half_cells_of(const std::vector<double>& places, int round_from) {
    const double wanted = 0.6 * nth(places, round_from);
    int best = 1;
    for (int i = 2; i < round_from; ++i)
      if (std::abs(nth(places, i) - wanted) < std::abs(nth(places, best) - wanted)) best = i;
    return best;
  }
  [[nodiscard]] int half_cells() const { return half_cells_; }
  [[nodiscard]] int shells() const { return static_cast<int>(places_.size()) - 1 - half_cells_; }
  [[nodiscard]] double radius() const { return places_.back(); }

  [[nodiscard]] Vec3 inside(const std::array<int, 3>& cell) const {
    const int layer = std::max({std::abs(cell[0]), std::abs(cell[1]), std::abs(cell[2])});
    if (layer == 0) return Vec3::Zero();
    const double step = width_ * nth(places_, round_from_) / round_from_, ball_share = 0.4;
    const Vec3 cube(level(cell[0]), level(cell[1]), level(cell[2]));
    return step * ((1 - ball_share) * cube + ball_share * level(layer) * direction(cell, layer));
  }

  /// `shell` 0 is the core's surface, `shells` the circle or sphere; `cell` lies on the core's surface.
  [[nodiscard]] Vec3 outside(const std::array<int, 3>& cell, int shell) const {
    const int place = half_cells_ + shell;
    const Vec3 unit = direction(cell, half_cells_);
    if (place >= round_from_) return nth(places_, place) * unit;
    const Vec3 inner = inside(cell), outer = nth(places_, round_from_) * unit;
    return inner + (outer - inner) * (level(place) - level(half_cells_)) / (level(round_from_) - level(half_cells_));
  }

 private:
  static std::vector<double> even(double radius, int elements) {
    std::vector<double> places;
    for (int i = 0; i < elements; ++i) places.push_back(radius * i / elements);
    places.push_back(radius);
    return places;
  }

  /// A place in units of the mean element of the first `round_from_`.
  [[nodiscard]] double level(int i) const { return std::copysign(nth(level_, std::abs(i)), i); }

  /// Equal angles between neighbours along each axis.
  static Vec3 direction(const std::array<int, 3>& cell, int layer) {
    const auto slope = [layer](int i) {
      return std::abs(i) == layer ? std::copysign(1.0, i) : std::tan(std::numbers::pi / 4 * i / layer);
    };
    return Vec3(slope(cell[0]), slope(cell[1]), slope(cell[2])).normalized();
  }

  std::vector<double> places_, level_;
  double width_;
  int round_from_, half_cells_;
};

}  // namespace brunt::mesh
