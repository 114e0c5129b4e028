// SPDX-License-Identifier: Apache-2.0
// Generalized penetration depth of two rigid bodies with closed surfaces: the shortest rigid motion of A, in a metric,
// after which the interiors have no common point. No path is asked for.
//
// L. Zhang, Y. J. Kim, D. Manocha, A fast and practical algorithm for generalized penetration depth computation (2007).
// The answer is an upper bound (its placement is free) and a proven lower bound. Equal input gives equal bits.
#pragma once
#include <cstdint>
#include <vector>

#include "brunt/depth/body.hpp"
#include "brunt/depth/cover.hpp"
#include "brunt/depth/encounter.hpp"

namespace brunt::depth {

struct Query {
  Placement a_in_b;  ///< from file coordinates of A to those of B
  Metric metric = Metric::displacement;
  bool careful = false;          ///< many starts, all metrics help each other, contact to 1e-9 of A's radius
  double clearance = 1e-6;       ///< kept by walks until the final contact, in units of A's radius
  double apart = 0;              ///< distance left between the surfaces; 0: contact [length]
  std::vector<Vec3> along;       ///< directions of admitted translations, axes of B; none: all. For `translation` only
  std::vector<Placement> tries;  ///< placements to start from as well: those of the other metrics, the last answer
  bool warm = false;             ///< start from `tries` alone if that leads to 1.3 times the bound: coherent motion
  std::int64_t boxes = 0;        ///< certificate: raise the bound by covering with at most so many boxes (cover.hpp)
  double gap = 0.02;             ///< ends where the bound is this near to the depth, relative
  Evaluate evaluate;             ///< judges batches of boxes, for instance on several processes; none: here
  std::function<bool()> stop;    ///< ends the certificate when true, for instance after some time; none: never
};

struct ContactPoint {
  Vec3 point = Vec3::Zero();   ///< at the final placement, in the coordinates of B [length]
  Vec3 normal = Vec3::Zero();  ///< from B to A
  double gap = 0;              ///< [length]
};

struct Answer {
  bool overlap = false;
  bool found = true;    ///< false: no free placement (`along` may admit none)
  double depth = 0;     ///< [length]; 0 without overlap
  double bound = 0;     ///< nothing shorter is free: proven, up to rounding [length]
  double distance = 0;  ///< of the surfaces, where they do not overlap [length]
  Placement placement;  ///< of A after the motion, in the coordinates of B
  RigidMotion motion;   ///< in the axes of A at the given placement
  std::vector<ContactPoint> contacts;
  bool certified = false;  ///< the gap asked for was reached
  std::int64_t boxes = 0;  ///< judged
  int walks = 0, steps = 0;
  std::int64_t queries = 0;  ///< collision queries
  std::int64_t pairs = 0;    ///< near pairs of triangles found by walks
};

[[nodiscard]] Answer penetration_depth(const Body& a, const Body& b, const Query& query);

}  // namespace brunt::depth
