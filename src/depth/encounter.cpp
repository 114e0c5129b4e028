// SPDX-License-Identifier: Apache-2.0
#include "depth/encounter.hpp"

#include <algorithm>
#include <cmath>

namespace brunt::depth {
namespace {

constexpr double kept_bits = 0x1p40;

}  // namespace

bool Encounter::bodies_collide(const Placement& a_in_b) const {
  if (apart > 0 ? geometry::surface_distance(a.tree, b.tree, a_in_b, apart) < apart
                : geometry::surfaces_cross(a.tree, b.tree, a_in_b))
    return true;
  const auto holds = [](const geometry::SlabTree& tree, const Vec3& x) {
    return geometry::contains(tree.box, x) && geometry::contains(tree, x);
  };
  return std::any_of(a.components.begin(), a.components.end(),
                     [&](const Vec3& x) { return holds(b.tree, a_in_b(x)); }) ||
         std::any_of(b.components.begin(), b.components.end(),
                     [&](const Vec3& x) { return holds(a.tree, a_in_b.back(x)); });
}

Placement rounded(const Placement& a_in_b, double size) {
  Eigen::Quaterniond q(a_in_b.rotation);
  q.normalize();
  if (q.w() < 0) q.coeffs() *= -1;
  for (double& entry : q.coeffs()) entry = std::round(entry * kept_bits) / kept_bits;
  q.normalize();
  Placement result;
  result.rotation = q.toRotationMatrix();
  const double unit = std::exp2(std::ceil(std::log2(size))) / kept_bits;
  for (int i = 0; i < 3; ++i) result.translation[i] = std::round(a_in_b.translation[i] / unit) * unit;
  return result;
}

}  // namespace brunt::depth
