// SPDX-License-Identifier: Apache-2.0
// The outline of a nose in a half plane through its axis, from the shoulder to where it ends.
#pragma once
#include <array>

#include "mesh/round_form.hpp"

namespace brunt::mesh {

/// Heights are above the shoulder.
class Outline {
 public:
  /// `inner`: radius of a bore, 0 for none. The nose ends at its flat tip, else at the bore or the axis.
  Outline(const Nose& nose, double radius, double inner);

  /// (radius, height) at a share of the way, from 0 at the shoulder to 1 at the end. Equal steps are equally long.
  [[nodiscard]] std::array<double, 2> at(double share) const;
  [[nodiscard]] double height() const { return at(1)[1]; }
  [[nodiscard]] double length() const;  ///< along the outline

 private:
  Nose::Shape shape_;
  double radius_, end_;
  double height_ = 0;             ///< of a cone at its end
  double arc_ = 0, opening_ = 0;  ///< of an ogive, a hemisphere: radius and angle of its arc
};

}  // namespace brunt::mesh
