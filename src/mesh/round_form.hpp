// SPDX-License-Identifier: Apache-2.0
// Parts of a complete cylinder or tube (half, quarter, sector), and noses.
#pragma once
#include <array>

#include "core/types.hpp"

namespace brunt::mesh {

/// For x, y, z: 1 keeps the part at or above 0, -1 the part at or below 0, 0 both. Two halves make a quarter. The cut
/// planes are sets, PART_xmin if x >= 0 is kept, PART_xmax if x <= 0; the coordinate of their nodes is exactly 0.
using Half = std::array<int, 3>;

/// The part between two half planes through the axis z, at these angles from the x axis [degrees]. The cut planes are
/// the sets PART_from and PART_to. No sector: both 0.
struct Sector {
  double from = 0, to = 0;
  [[nodiscard]] bool cuts() const { return to > from; }
  friend bool operator==(const Sector&, const Sector&) = default;
};

/// A tip beyond the upper end, connected to the body. Lengths in the unit of the body.
struct Nose {
  enum class Shape {
    none,
    hemisphere,
    cone,
    ogive,  ///< its outline is an arc tangent to the side
  };
  Shape shape = Shape::none;
  double length = 0;      ///< of a cone, from shoulder to tip
  double crh = 0;         ///< of an ogive: radius of its arc over the diameter, >= 0.5
  double tip_radius = 0;  ///< radius of the flat end of a cone or an ogive; 0: pointed
  int elements = 0;       ///< number from shoulder to flat tip; 0: elements as long as they are across the radius
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
