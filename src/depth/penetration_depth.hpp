// SPDX-License-Identifier: Apache-2.0
// Generalized penetration depth of two rigid bodies with closed surfaces: the shortest rigid motion of A, in a metric,
// after which the interiors have no common point. The motion need not be free along its path.
//
// L. Zhang, Y. J. Kim, D. Manocha, A fast and practical algorithm for generalized penetration depth computation (2007).
// The result is an upper bound (its placement is free) and a proven lower bound. Equal input gives equal bits.
#pragma once
#include <cstdint>
#include <vector>

#include "depth/body.hpp"
#include "depth/cover.hpp"
#include "depth/encounter.hpp"

namespace brunt::depth {

struct Query {
  Placement a_in_b;  ///< from file coordinates of A to those of B
  Metric metric = Metric::displacement;
  bool careful = false;          ///< many starting points, metrics share their results, contact to 1e-9 of A's radius
  double clearance = 1e-6;       ///< kept by descents until the final contact, in units of A's radius
  double apart = 0;              ///< distance left between the surfaces; 0: contact [length]
  std::vector<Vec3> along;       ///< admissible directions of translation, axes of B; none: all. For `translation` only
  std::vector<Placement> tries;  ///< further starting placements: those of the other metrics, the last result
  bool warm = false;             ///< start from `tries` only if that leads to 1.2 times the bound: coherent motion
  bool touching = false;         ///< surfaces that only touch are parted as well, by the accuracy of the mode
  std::int64_t boxes =
      0;              ///< certificate: increase the bound by covering with at most this number of boxes (cover.hpp)
  double gap = 0.02;  ///< relative difference of depth and bound at which it ends
  Evaluate evaluate;  ///< judges batches of boxes, for instance on several processes; none: here
  std::function<bool()> stop;  ///< ends the certificate when true, for instance after some time; none: never
};

struct ContactPoint {
  Vec3 point = Vec3::Zero();   ///< at the final placement, in the coordinates of B [length]
  Vec3 normal = Vec3::Zero();  ///< from B to A
  double gap = 0;              ///< [length]
};

struct Answer {
  bool overlap = false;
  bool found = true;    ///< false: no free placement (`along` may not admit one)
  double depth = 0;     ///< [length]; 0 without overlap
  double bound = 0;     ///< no shorter motion is free [length]
  bool proven = true;   ///< the bound is, up to rounding; false where a surface crosses itself
  double overlaps = 0;  ///< at the given placement: the sum of the greatest overlaps of separate regions [length]
  double distance = 0;  ///< of the surfaces if they do not overlap [length]
  Placement placement;  ///< of A after the motion, in the coordinates of B
  RigidMotion motion;   ///< in the axes of A at the given placement
  std::vector<ContactPoint> contacts;
  bool certified = false;  ///< the requested gap was reached
  std::int64_t boxes = 0;  ///< judged
  int walks = 0, steps = 0;
  std::int64_t queries = 0;  ///< collision queries
  std::int64_t pairs = 0;    ///< near pairs of triangles found by walks
};

/// Whether the depth is more than the overlaps together: a shorter motion may have been missed.
[[nodiscard]] bool far_above_overlaps(const Answer& answer);

[[nodiscard]] Answer penetration_depth(const Body& a, const Body& b, const Query& query);

}  // namespace brunt::depth
