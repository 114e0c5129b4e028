// SPDX-License-Identifier: Apache-2.0
// Body A at the given placement and body B, with the number of collision queries.
#pragma once
#include <cstdint>

#include "depth/body.hpp"
#include "depth/rigid_motion.hpp"

namespace brunt::depth {

struct Encounter {
  const Body& a;  ///< moves
  const Body& b;
  Placement start;           ///< q_0: file coordinates of A to those of B
  std::int64_t queries = 0;  ///< collision queries so far
  double apart = 0;          ///< surfaces closer to each other also count as colliding [length]

  [[nodiscard]] Placement placement(const RigidMotion& motion) const { return moved(start, motion, a.shape.centroid); }
  /// Surfaces intersect, touch or are closer than `apart`, or a part of one body lies inside the other.
  [[nodiscard]] bool collides(const RigidMotion& motion) {
    ++queries;
    return bodies_collide(placement(motion));
  }
  [[nodiscard]] bool bodies_collide(const Placement& a_in_b) const;
};

/// Entries of the rotation, and the translation in units of `size`, rounded to 40 bits after the point; the rotation is
/// orthogonalised again. A different position of the common frame then gives the same bits in nearly all cases.
[[nodiscard]] Placement rounded(const Placement& a_in_b, double size);

}  // namespace brunt::depth
