// SPDX-License-Identifier: Apache-2.0
// What makes of a whole cylinder or tube a part of it, or one with a nose.
#pragma once
#include <array>

#include "brunt/core/types.hpp"

namespace brunt::mesh {

/// Of x, y, z: 1 keeps what lies at or above 0, -1 what lies at or below, 0 both. Two make a quarter. The cut planes
/// are sets, PART_xmin where x >= 0 is kept, PART_xmax where x <= 0 is; their nodes have the coordinate 0 exactly.
using Half = std::array<int, 3>;

/// What lies between two half planes through the axis z, at these angles from the x axis [degrees]. The cut planes are
/// the sets PART_from and PART_to. No sector: both 0.
struct Sector {
  double from = 0, to = 0;
  [[nodiscard]] bool cuts() const { return to > from; }
  friend bool operator==(const Sector&, const Sector&) = default;
};

/// A tip beyond the upper end, of one body with it. Lengths as the body's.
struct Nose {
  enum class Shape {
    none,
    hemisphere,
    cone,
    ogive,  ///< its outline is an arc that is tangent to the side
  };
  Shape shape = Shape::none;
  double length = 0;      ///< of a cone, from shoulder to tip
  double crh = 0;         ///< of an ogive: radius of its arc over the diameter, >= 0.5
  double tip_radius = 0;  ///< of a cone, an ogive: of the flat that ends it; 0: it is pointed
  int elements = 0;       ///< from shoulder to flat tip; 0: as long as they are across the radius
  friend bool operator==(const Nose&, const Nose&) = default;
};

struct RoundForm {
  Half half{};
  Sector sector;
  Nose nose;
  RoundForm() = default;
  RoundForm(const Half& sides) : half(sides) {}  // NOLINT: a half is the plainest form
  RoundForm(int x, int y, int z) : half{x, y, z} {}
  friend bool operator==(const RoundForm& form, const Half& sides) { return form == RoundForm(sides); }
  friend bool operator==(const RoundForm&, const RoundForm&) = default;
};

}  // namespace brunt::mesh
