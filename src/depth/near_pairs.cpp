// SPDX-License-Identifier: Apache-2.0
#include "depth/near_pairs.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace brunt::depth {
namespace {

constexpr double same_point = 1e-9;  // of A's size

constexpr double same_way = 0.5;  // cosine of the angle between n and an axis that may replace it

constexpr double clear_gain = 1e-12;  // of the coordinates: least improvement of an axis over another
constexpr double parallel = 1e-7;     // sine: the product of parallel edges is undefined

/// Gap along the unit vector `axis`, from b to a.
double gap_along(const geometry::Triangle& a, const geometry::Triangle& b, const Vec3& axis) {
  const double low = std::min({axis.dot(a[0]), axis.dot(a[1]), axis.dot(a[2])});
  const double high = std::max({axis.dot(b[0]), axis.dot(b[1]), axis.dot(b[2])});
  return low - high;
}

/// Gap along the axis u of any length; -infinity if its angle to n is too large.
double gap_along(const geometry::Triangle& a, const geometry::Triangle& b, const Vec3& u, const Vec3& n) {
  const double length = u.norm(), along = u.dot(n);
  if (!(std::abs(along) > same_way * length)) return -std::numeric_limits<double>::infinity();
  return gap_along(a, b, u * ((along > 0 ? 1 : -1) / length));
}

std::array<Vec3, 3> edges_of(const geometry::Triangle& t) {
  return {t[1] - t[0], t[2] - t[1], t[0] - t[2]};
}

}  // namespace

double gap_of(const geometry::Triangle& a, const geometry::Triangle& b, const Vec3& n) {
  const std::array<Vec3, 3> ea = edges_of(a), eb = edges_of(b);
  double gap = std::max(gap_along(a, b, ea[0].cross(ea[1]), n), gap_along(a, b, eb[0].cross(eb[1]), n));
  for (const Vec3& x : ea)
    for (const Vec3& y : eb) gap = std::max(gap, gap_along(a, b, x.cross(y), n));
  return std::max(gap, gap_along(a, b, n, n));
}

Vec3 separating_axis(const geometry::Triangle& a, const geometry::Triangle& b) {
  const std::array<Vec3, 3> ea = edges_of(a), eb = edges_of(b);
  const double size = std::max(a[0].cwiseAbs().maxCoeff(), b[0].cwiseAbs().maxCoeff());
  Vec3 best = Vec3::Zero();
  double gap = -std::numeric_limits<double>::infinity();
  const auto offer = [&](const Vec3& x, const Vec3& y) {
    const Vec3 product = x.cross(y);
    if (!(product.norm() > parallel * x.norm() * y.norm())) return;
    for (const double sign : {1., -1.}) {
      const Vec3 axis = sign * product.normalized();
      const double here = gap_along(a, b, axis);
      if (!(here > gap + clear_gain * size)) continue;
      gap = here;
      best = axis;
    }
  };
  offer(eb[0], eb[1]);
  offer(ea[0], ea[1]);
  for (const Vec3& x : ea)
    for (const Vec3& y : eb) offer(x, y);
  return best;
}

void NearPairs::find(const Encounter& encounter, const RigidMotion& motion, double band, double margin) {
  const Placement now = encounter.placement(motion);
  geometry::near_pairs(encounter.a.tree, encounter.b.tree, now, band, pairs);
  const Vec3 centre = now(encounter.a.shape.centroid);
  const Mat3 into = encounter.start.rotation.transpose();
  const double grid = same_point * encounter.a.shape.radius;
  struct Key {
    std::array<double, 6> at;
    std::size_t pair;
  };
  std::vector<Key> keys;
  keys.reserve(pairs.size());
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    if (!(pairs[i].distance > 0)) continue;
    Key key{{}, i};
    for (std::size_t c = 0; c < 3; ++c) {
      key.at[c] = std::round(pairs[i].on_a[static_cast<int>(c)] / grid);
      key.at[c + 3] = std::round(pairs[i].on_b[static_cast<int>(c)] / grid);
    }
    keys.push_back(key);
  }
  std::sort(keys.begin(), keys.end(),
            [](const Key& x, const Key& y) { return x.at != y.at ? x.at < y.at : x.pair < y.pair; });
  conditions.clear();
  for (std::size_t i = 0; i < keys.size(); ++i) {
    if (i > 0 && keys[i].at == keys[i - 1].at) continue;
    const geometry::NearPair& pair = pairs[keys[i].pair];
    conditions.push_back({into * ((pair.on_a - pair.on_b) / pair.distance), into * (pair.on_a - centre), pair.distance,
                          std::min(0.0, margin - pair.distance), pair.a, pair.b});
  }
}

void NearPairs::forget_corrections(double margin) {
  for (NearCondition& condition : conditions) condition.bound = std::min(0.0, margin - condition.distance);
}

bool correct_bounds(const Encounter& encounter, const RigidMotion& motion, const Vec3& tau, const Vec3& omega,
                    double margin, std::span<NearCondition> conditions) {
  const Placement now = encounter.placement(motion);
  const Mat3& out = encounter.start.rotation;
  bool grew = false;
  for (NearCondition& condition : conditions) {
    geometry::Triangle a = nth(encounter.a.tree.triangles, condition.a);
    for (Vec3& corner : a) corner = now(corner);
    const geometry::Triangle& b = nth(encounter.b.tree.triangles, condition.b);
    const double gap = gap_of(a, b, out * condition.normal);
    if (!(gap < margin) || !std::isfinite(gap)) continue;
    const double bound = condition.normal.dot(tau + omega.cross(condition.arm)) + (margin - gap);
    if (!(bound > condition.bound)) continue;
    condition.bound = bound;
    grew = true;
  }
  return grew;
}

}  // namespace brunt::depth
