// SPDX-License-Identifier: Apache-2.0
// Tests of one box against eight boxes, sixteen boxes or sixteen points at once.
#pragma once
#include "contact/search/point_blocks.hpp"

namespace brunt::contact {

/// The bounds of a box, low x y z, high x y z, and two unused entries.
struct Bounds {
  Octet lanes;
};

using FloatPack = float __attribute__((vector_size(32)));

/// A box relative to the origin of a block, rounded as the block's points are.
struct BlockBox {
  FloatPack bounds;

  BRUNT_INLINE BlockBox(const Bounds& box, const BlockOrigin& origin)
      : bounds(__builtin_convertvector(box.lanes - origin.twice, FloatPack)) {}
  [[nodiscard]] BRUNT_INLINE FloatLanes low(int axis) const { return every_lane(bounds[axis]); }
  [[nodiscard]] BRUNT_INLINE FloatLanes high(int axis) const { return every_lane(bounds[axis + 3]); }
};

/// Children of the node whose boxes touch or overlap the box.
BRUNT_INLINE LaneMask touching(const NodeBoxes& node, const double (&low)[3], const double (&high)[3]) {
  LaneMask mask = 0xFF;
  for (int a = 0; a < 3; ++a) {
    mask = not_above(mask, load(node.low[a]), every_lane(high[a]));
    mask = not_above(mask, every_lane(low[a]), load(node.high[a]));
  }
  return mask;
}

/// Runs that may hold points of the box.
BRUNT_INLINE LaneMask touching(const RunBoxes& runs, const BlockBox& box) {
  LaneMask mask = 0xFFFF;
  for (int a = 0; a < 3; ++a) {
    mask = not_above(mask, load(runs.low[a]), box.high(a));
    mask = not_above(mask, box.low(a), load(runs.high[a]));
  }
  return mask;
}

struct Holding {
  LaneMask possible = 0;  ///< all points in the box are among these
  LaneMask certain = 0;   ///< all of these are in the box
};

BRUNT_INLINE Holding holding(const BlockBox& box, const Run& run) {
  Holding held{0xFFFF, 0xFFFF};
  for (int a = 0; a < 3; ++a) {
    const FloatLanes x = load(run.x[a]), low = box.low(a), high = box.high(a);
    held.possible = not_above(not_above(held.possible, low, x), x, high);
    held.certain = below(below(held.certain, low, x), x, high);
  }
  return held;
}

}  // namespace brunt::contact
