// SPDX-License-Identifier: Apache-2.0
// Boxes of one tree against the eight boxes of a node of another: lower bounds of the distance, from the axes of both
// bodies and from the further directions of the node's tree.
#pragma once
#include <bit>
#include <cstdint>

#include "geometry/triangles/slab_tree.hpp"
#include "octets.hpp"

namespace brunt::geometry {

/// Rounding of moved points and of the tests' sums, relative to the largest coordinate involved: boxes are enlarged by
/// it, so that no test separates the boxes of triangles that touch after placement and rounding.
constexpr double box_rounding = 64 * 0x1p-53;

/// A box along the axes of its own body.
struct OwnBox {
  Vec3 middle, half;
};

inline OwnBox child_box(const SlabNode& node, int lane) {
  return {{node.middle[0][lane], node.middle[1][lane], node.middle[2][lane]},
          {node.half[0][lane], node.half[1][lane], node.half[2][lane]}};
}

inline OwnBox own_box(const Box& box) {
  const Vec3 middle = 0.5 * (box.low + box.high);
  return {middle, (box.high - middle).cwiseMax(middle - box.low)};
}

/// From the axes of a box to those of a tree.
struct Relative {
  Mat3 rotation, size;            ///< size: of the components of the rotation
  Vec3 translation, turned_back;  ///< turned_back: the translation in the axes of the box
  double slack;                   ///< rounding [length]

  Relative(const Placement& placement, double scale)
      : rotation(placement.rotation),
        size(placement.rotation.cwiseAbs()),
        translation(placement.translation),
        turned_back(placement.rotation.transpose() * placement.translation),
        slack((box_rounding + 4 * distortion(placement.rotation)) * scale) {}

  /// Error of the orthogonality of products of rotations.
  static double distortion(const Mat3& r) { return (r.transpose() * r - Mat3::Identity()).cwiseAbs().sum(); }
};

inline Placement inverse(const Placement& p) {
  return {p.rotation.transpose(), p.rotation.transpose() * -p.translation};
}

/// A box in the axes of a tree, and in its own axes with the origin of the tree: each enlarged by the rounding bound.
struct PlacedBox {
  Vec3 middle, half;
  Vec3 own_middle, own_half;

  PlacedBox(const OwnBox& box, const Relative& relative)
      : middle(relative.rotation * box.middle + relative.translation),
        half((relative.size * box.half).array() + relative.slack),
        own_middle(box.middle + relative.turned_back),
        own_half(box.half.array() + relative.slack) {}
  /// Of a placed triangle, whose box along the tree's axes is known.
  PlacedBox(const OwnBox& placed, const OwnBox& box, const Relative& relative) : PlacedBox(box, relative) {
    middle = placed.middle;
    half = placed.half.array() + relative.slack;
  }
};

/// Of a box and the children of a node.
struct Gaps {
  Octet distance2;  ///< lower bound of the squared distance
  Octet widest;     ///< the largest gap along any direction, negative if all overlap: its size is then the depth
};

BRUNT_INLINE void widen(Gaps& gaps, Octet along, Octet& sum) {
  const Octet zero = Octet(), positive = octet_max(along, zero);
  gaps.widest = octet_max(gaps.widest, along);
  sum += positive * positive;
}

/// `node` of `tree`, number `index`.
BRUNT_INLINE Gaps gaps_to(const SlabTree& tree, std::size_t index, const PlacedBox& box, const Relative& relative) {
  const SlabNode& node = tree.nodes[index];
  Gaps gaps{Octet(), Octet() - std::numeric_limits<double>::infinity()};
  Octet sum = Octet();
  for (int k = 0; k < 3; ++k) widen(gaps, octet_abs(node.middle[k] - box.middle[k]) - node.half[k] - box.half[k], sum);
  const auto& r = relative.rotation;
  const auto& s = relative.size;
  Octet sum_own = Octet();
  for (int j = 0; j < 3; ++j) {
    const Octet middle = r(0, j) * node.middle[0] + r(1, j) * node.middle[1] + r(2, j) * node.middle[2];
    const Octet half = s(0, j) * node.half[0] + s(1, j) * node.half[1] + s(2, j) * node.half[2];
    widen(gaps, octet_abs(middle - box.own_middle[j]) - half - box.own_half[j], sum_own);
  }
  gaps.distance2 = octet_max(sum, sum_own);
  const std::size_t more = tree.directions.size();
  for (std::size_t m = 0; m < more; ++m) {
    const Vec3 direction = relative.rotation.transpose() * tree.directions[m];  // in the axes of the box
    const Octet* slab = &tree.slabs[2 * (index * more + m)];
    Octet alone = Octet();
    widen(gaps, octet_abs(slab[0] - direction.dot(box.own_middle)) - slab[1] - direction.cwiseAbs().dot(box.own_half),
          alone);
    gaps.distance2 = octet_max(gaps.distance2, alone);
  }
  return gaps;
}

}  // namespace brunt::geometry
