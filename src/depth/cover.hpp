// SPDX-License-Identifier: Apache-2.0
// A lower bound of penetration depth for the whole space of placements, by branch and bound.
//
// A box contains the rotation vectors within a half width h_w and the displacements of the centroid within half widths
// h_i along the axes of A at q_0, around its centre. Within it a point x of A moves by at most
//   m(x) = |h| + 2 sin(sqrt3 h_w/2) |x - c|
// from its position at the centre, since exp(w) and exp(w') differ by an angle of at most |w - w'|. A box is discarded
// if, at its centre, a ball of A and a point of B penetrate by more than this: every placement in it collides. For two
// convex pieces the smallest depth over the shifts alone is known exactly (narrowest_overlap), and the rotation reduces
// it by at most its part of m. Otherwise the box is divided in the direction that weakens the proof most: into eight
// parts along rotation, or into two along one axis of translation. A remaining box has no placement shorter than that
// of its points that must move farthest: the distance of d(y) + [-h, h] from the origin minus the rotational part of m.
// The smallest of these values is a lower bound at any time. Free centres below the upper bound are returned as
// starting points of descents.
//
// Boxes are judged in batches of a fixed size, each by a pure function: `evaluate` may distribute them to other
// processes, and the result has the same bits.
#pragma once
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "depth/encounter.hpp"

namespace brunt::depth {

struct CoverBox {
  Vec3 turn = Vec3::Zero(), shift = Vec3::Zero();  ///< middle: rotation vector [rad], displacement [length]
  Vec3 half_shift = Vec3::Zero();                  ///< [length]
  double half_turn = 0;                            ///< [rad]
  double least = 0;                                ///< no placement in it is shorter [length]
  std::int32_t hint = 0;                           ///< piece pair or ball that was closest to a proof in its parent
  [[nodiscard]] RigidMotion middle() const { return {rotation_of(turn), shift}; }
};

struct CoverVerdict {
  bool collides = false;  ///< everywhere in the box: proven
  bool free = false;      ///< its middle is free
  double length = 0;      ///< of its middle [length]
  std::int32_t hint = 0;
  std::int32_t cut = 0;  ///< best division: along this axis of translation, or 3: along rotation
};

/// A pure function. Free centres are examined only below `upper`.
[[nodiscard]] CoverVerdict judge(const Encounter& encounter, Metric metric, double upper, const CoverBox& box);

using Evaluate = std::function<void(std::span<const CoverBox>, double upper, std::span<CoverVerdict>)>;

struct CoverOptions {
  Metric metric = Metric::displacement;
  double gap = 0.02;                    ///< ends where the bound is this near to the upper bound, relative
  std::int64_t most_boxes = 1'000'000;  ///< judged
  double known = 0;                     ///< nothing shorter is free: proven before [length]
  Evaluate evaluate;                    ///< none: one after the other, here
  std::function<bool()> stop{};         ///< called before each batch: true ends the search, as most_boxes does
};

struct CoverResult {
  double bound = 0;  ///< [length]
  double upper = 0;  ///< [length]
  std::int64_t boxes = 0;
  bool reached = false;  ///< the gap was reached
};

/// `improve` receives a free motion below the upper bound and returns the new upper bound (the end of a descent).
[[nodiscard]] CoverResult cover(const Encounter& encounter, double upper, const CoverOptions& options,
                                const std::function<double(const RigidMotion&)>& improve);

}  // namespace brunt::depth
