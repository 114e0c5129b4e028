// SPDX-License-Identifier: Apache-2.0
// Generalized penetration depth of two rigid bodies with closed surfaces: the smallest rigid motion of A that separates
// it from B (Zhang, Kim and Manocha, IROS 2007). One rank computes it; nothing is collective.
#pragma once
#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace brunt::api {

/// A closed surface of triangles and what follows from it: made once, used for many queries.
class DepthBody {
 public:
  /// points: x, y, z of each [length]; triangles: three corners each, counter-clockwise seen from outside. Throws
  /// std::invalid_argument, which names the first fault, for a surface that is not closed or not oriented outward.
  DepthBody(std::span<const double> points, std::span<const std::int32_t> triangles);

  struct Data;
  [[nodiscard]] const Data& data() const { return *data_; }

 private:
  std::shared_ptr<const Data> data_;
};

/// x -> rotation x + translation.
struct Placement {
  std::array<double, 9> rotation{1, 0, 0, 0, 1, 0, 0, 0, 1};  ///< proper orthogonal, row by row
  std::array<double, 3> translation{};                        ///< [length]
};

/// What is meant by the length of a motion of A.
enum class Metric : std::int8_t {
  translation,   ///< length of a translation, without rotation
  displacement,  ///< the largest displacement of a point of A
  object_norm    ///< the root mean square displacement of A's points
};

struct DepthAnswer {
  bool overlap = false;
  double depth = 0;     ///< length of the motion: an upper bound of the depth, since it separates [length]
  double bound = 0;     ///< no shorter motion separates [length]
  double distance = 0;  ///< of the surfaces where they do not overlap [length]
  Placement placement;  ///< of A after the motion
};

/// a_in_b: the placement of A in the coordinates of B. careful: more starting points, better and slower.
DepthAnswer penetration_depth(const DepthBody& a, const DepthBody& b, const Placement& a_in_b,
                              Metric metric = Metric::displacement, bool careful = false);

}  // namespace brunt::api
