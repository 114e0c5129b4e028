// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include "geometry/triangles/slab_tree.hpp"
#include "slab_boxes.hpp"
#include "triangle_point.hpp"

namespace brunt::geometry {
namespace {

/// If the angle between the vector from the nearest point and the plane perpendicular to the pseudo-normal is smaller
/// (sine), rounding may determine the sign: at sharp edges, and for points on the surface up to rounding.
constexpr double clear_sine = 1e-6;

struct NearestTriangle {
  double distance2 = std::numeric_limits<double>::infinity();
  LocalIndex triangle = no_index;
};

/// Descends to the triangle nearest to a point; of equally near ones to that with the lowest number.
class Descent {
 public:
  /// Ends as soon as a triangle is nearer than `near_enough`.
  Descent(const SlabTree& tree, const Vec3& x, double at_most2, double near_enough2 = 0)
      : tree_(tree),
        x_(x),
        lanes_{Octet() + x[0], Octet() + x[1], Octet() + x[2]},
        slack_(box_rounding *
               (x.cwiseAbs().maxCoeff() + tree.box.low.cwiseAbs().cwiseMax(tree.box.high.cwiseAbs()).maxCoeff())),
        near_enough2_(near_enough2) {
    nearest_.distance2 = at_most2;
    if (!tree.nodes.empty()) below(0);
  }
  [[nodiscard]] const NearestTriangle& nearest() const { return nearest_; }

 private:
  void below(std::size_t index) {
    const SlabNode& node = tree_.nodes[index];
    if (node.leaf != no_index) {
      leaf(node);
      return;
    }
    Octet distance2 = Octet();
    for (int k = 0; k < 3; ++k) {
      const Octet gap = octet_max(octet_abs(node.middle[k] - x_[k]) - node.half[k] - slack_, Octet());
      distance2 += gap * gap;
    }
    unsigned left = lanes_up_to(distance2, Octet() + nearest_.distance2);
    while (left != 0) {
      int first = std::countr_zero(left);
      for (unsigned rest = left & (left - 1); rest != 0; rest &= rest - 1) {
        const int lane = std::countr_zero(rest);
        if (distance2[lane] < distance2[first]) first = lane;
      }
      if (!(distance2[first] <= nearest_.distance2) || nearest_.distance2 < near_enough2_) return;
      left &= ~(1U << first);
      below(static_cast<std::size_t>(nth(node.child, first)));
    }
  }

  void leaf(const SlabNode& node) {
    const SlabLeaf& l = nth(tree_.leaves, node.leaf);
    const auto vector = [](const Octet(&of)[3]) { return VecOf<Octet>{of[0], of[1], of[2]}; };
    const Octet distance2 = distance2_to_triangle<Octet>(
        lanes_, {vector(l.corner[0]), vector(l.corner[1]), vector(l.corner[2]), vector(l.normal), l.inverse2[0],
                 l.inverse2[1], l.inverse2[2], l.inverse2[3]});
    for (unsigned left = lanes_up_to(distance2, Octet() + nearest_.distance2) & ((1U << node.count) - 1); left != 0;
         left &= left - 1) {
      const int lane = std::countr_zero(left);
      const LocalIndex triangle = nth(node.child, lane);
      const bool first = nearest_.triangle == no_index || triangle < nearest_.triangle;
      if (distance2[lane] < nearest_.distance2 || (distance2[lane] == nearest_.distance2 && first))
        nearest_ = {distance2[lane], triangle};
    }
  }

  const SlabTree& tree_;
  const Vec3& x_;
  VecOf<Octet> lanes_;
  double slack_, near_enough2_;
  NearestTriangle nearest_;
};

bool inside(const SlabTree& tree, const Vec3& x, const Vec3& away, const Vec3& normal) {
  const double outward = away.dot(normal), distance = away.norm();
  if (std::abs(outward) > clear_sine * distance) return outward < 0;
  return winding_number(tree.triangles, x) > 0.5;
}

PointDepth depth_at(const SlabTree& tree, const Vec3& x, LocalIndex triangle) {
  const auto t = static_cast<std::size_t>(triangle);
  const OnTriangle on = nearest_on(tree.triangles[t], x);
  const Vec3 away = x - on.point;
  const double distance = away.norm();
  if (distance == 0) return {0, on.point, triangle};
  const Vec3& normal = nth(tree.normals[t], on.feature);
  return {inside(tree, x, away, normal) ? distance : -distance, on.point, triangle};
}

}  // namespace

PointDepth point_depth(const SlabTree& tree, const Vec3& x) {
  return point_depth(tree, x, std::numeric_limits<double>::infinity());
}

PointDepth point_depth(const SlabTree& tree, const Vec3& x, double at_most) {
  const NearestTriangle nearest = Descent(tree, x, at_most * at_most).nearest();
  if (nearest.triangle == no_index) return {at_most, x, no_index};
  return depth_at(tree, x, nearest.triangle);
}

double depth_above(const SlabTree& tree, const Vec3& x, double least) {
  constexpr double infinite = std::numeric_limits<double>::infinity();
  if (least >= 0 && !contains(tree.box, x)) return -infinite;
  const double enough2 = least > 0 ? least * least : 0.0;
  const NearestTriangle nearest = Descent(tree, x, infinite, enough2).nearest();
  if (nearest.distance2 < enough2 || nearest.triangle == no_index) return -infinite;
  return depth_at(tree, x, nearest.triangle).depth;
}

bool contains(const SlabTree& tree, const Vec3& x) {
  return contains(tree.box, x) && point_depth(tree, x).depth >= 0;
}

double winding_number(std::span<const Triangle> triangles, const Vec3& x) {
  constexpr double pi = 3.14159265358979323846;
  double sum = 0;
  for (const Triangle& t : triangles) {
    const Vec3 a = t[0] - x, b = t[1] - x, c = t[2] - x;
    const double la = a.norm(), lb = b.norm(), lc = c.norm();
    sum += std::atan2(a.dot(b.cross(c)), la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb);
  }
  return sum / (2 * pi);
}

double winding_number(const TriangleSurface& surface, const Vec3& x) {
  std::vector<Triangle> triangles;
  for (const auto& corners : surface.triangles) {
    Triangle& triangle = triangles.emplace_back();
    for (std::size_t i = 0; i < 3; ++i) triangle[i] = nth(surface.points, corners[i]);
  }
  return winding_number(triangles, x);
}

}  // namespace brunt::geometry
