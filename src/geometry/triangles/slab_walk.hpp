// SPDX-License-Identifier: Apache-2.0
// Simultaneous traversal of two trees: nodes whose boxes may be near, then single triangles of a against the tree of b.
#pragma once
#include "slab_boxes.hpp"

namespace brunt::geometry {

inline Triangle placed(const Triangle& t, const Placement& placement) {
  return {placement(t[0]), placement(t[1]), placement(t[2])};
}

inline double greatest_coordinate(const Box& box) {
  return box.low.cwiseAbs().cwiseMax(box.high.cwiseAbs()).maxCoeff();
}

/// `Visit` is called with (triangle of a, its placed corners, triangle of b) for all pairs that may be as near as
/// `limit` [length], which it may lower; it returns true to end the walk.
template <class Visit>
class SlabWalk {
 public:
  SlabWalk(const SlabTree& a, const SlabTree& b, const Placement& a_in_b, double limit, Visit& visit)
      : a_(a),
        b_(b),
        a_in_b_(a_in_b),
        forth_(a_in_b, scale(a, b, a_in_b)),
        back_(inverse(a_in_b), scale(a, b, a_in_b)),
        visit_(visit) {
    set_limit(limit);
  }

  /// Finite, so that lanes without a child, whose distance is infinite, are never within it.
  void set_limit(double limit) { limit2_ = std::min(limit * limit, std::numeric_limits<double>::max()); }

  /// True if a visit ended the traversal.
  bool run() {
    if (a_.nodes.empty() || b_.nodes.empty()) return false;
    return nodes(0, own_box(a_.box), 0, own_box(b_.box));
  }

 private:
  static double scale(const SlabTree& a, const SlabTree& b, const Placement& a_in_b) {
    return 2 * greatest_coordinate(a.box) + greatest_coordinate(b.box) + a_in_b.translation.cwiseAbs().maxCoeff();
  }

  /// Calls work(lane) for children within the limit, in descending order of overlap.
  template <class Work>
  bool by_nearness(const Gaps& gaps, const Work& work) {
    unsigned left = lanes_up_to(gaps.distance2, Octet() + limit2_);
    while (left != 0) {
      int nearest = std::countr_zero(left);
      for (unsigned rest = left & (left - 1); rest != 0; rest &= rest - 1) {
        const int lane = std::countr_zero(rest);
        if (gaps.widest[lane] < gaps.widest[nearest]) nearest = lane;
      }
      left &= ~(1U << nearest);
      if (gaps.distance2[nearest] <= limit2_ && work(nearest)) return true;
    }
    return false;
  }

  /// Node `i` of a with its box against node `j` of b: the larger one is expanded, but triangles of b are tested last.
  bool nodes(std::size_t i, const OwnBox& box_a, std::size_t j, const OwnBox& box_b) {
    const bool open_b = b_.nodes[j].leaf == no_index && box_b.half.maxCoeff() > box_a.half.maxCoeff();
    if (open_b)
      return by_nearness(gaps_to(b_, j, PlacedBox(box_a, forth_), forth_), [&](int lane) {
        return nodes(i, box_a, child(b_.nodes[j], lane), child_box(b_.nodes[j], lane));
      });
    const SlabNode& node = a_.nodes[i];
    return by_nearness(gaps_to(a_, i, PlacedBox(box_b, back_), back_), [&](int lane) {
      const OwnBox box = child_box(node, lane);
      if (node.leaf == no_index) return nodes(child(node, lane), box, j, box_b);
      const LocalIndex triangle = nth(node.child, lane);
      const Triangle corners = placed(nth(a_.triangles, triangle), a_in_b_);
      const PlacedBox placed_box(own_box(bounding_box(corners)), box, forth_);
      return triangle_below(triangle, corners, placed_box, j);
    });
  }

  bool triangle_below(LocalIndex triangle, const Triangle& corners, const PlacedBox& box, std::size_t j) {
    const SlabNode& node = b_.nodes[j];
    return by_nearness(gaps_to(b_, j, box, forth_), [&](int lane) {
      if (node.leaf == no_index) return triangle_below(triangle, corners, box, child(node, lane));
      return visit_(triangle, corners, nth(node.child, lane));
    });
  }

  static std::size_t child(const SlabNode& node, int lane) { return static_cast<std::size_t>(nth(node.child, lane)); }

  const SlabTree &a_, &b_;
  const Placement& a_in_b_;
  Relative forth_, back_;
  Visit& visit_;
  double limit2_ = 0;
};

}  // namespace brunt::geometry
