// SPDX-License-Identifier: Apache-2.0
// Crossings and first contact of segments.
#include "geometry/segments.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "geometry/box.hpp"
#include "geometry/closest_point.hpp"
#include "geometry/first_contact.hpp"
#include "geometry/trilinear.hpp"

namespace brunt::geometry {
namespace {

Vec3 direction(const Segment& a) {
  return a.end - a.start;
}

Vec3 point_at(const Segment& a, double s) {
  return (1 - s) * a.start + s * a.end;
}

Along along(double s, double tolerance) {
  if (s <= tolerance) return Along::start;
  return s >= 1 - tolerance ? Along::end : Along::inside;
}

struct Parameters {
  double s = 0, t = 0;
};

/// The intersection of the two lines in the projection along a direction (of any length); none if the projections are
/// parallel.
std::optional<Parameters> feet_along(const Segment& a, const Segment& b, const Vec3& seen, double least_sine) {
  const Vec3 p = direction(a), q = direction(b), offset = b.start - a.start;
  const double area = p.cross(q).dot(seen);
  if (!(area * area > least_sine * least_sine * p.squaredNorm() * q.squaredNorm() * seen.squaredNorm()))
    return std::nullopt;
  return Parameters{offset.cross(q).dot(seen) / area, offset.cross(p).dot(seen) / area};
}

bool inside(double s, double tolerance) {
  return s >= -tolerance && s <= 1 + tolerance;
}

bool may_meet(const MovingSegment& a, const MovingSegment& b) {
  const auto box = [](const Segment& segment) {
    Box result;
    extend(result, segment.start);
    extend(result, segment.end);
    return result;
  };
  const Box a0 = box(a.start), a1 = box(a.end), b0 = box(b.start), b1 = box(b.end);
  const Vec3 low = (a0.low - b0.high).cwiseMin(a1.low - b1.high), high = (a0.high - b0.low).cwiseMax(a1.high - b1.low);
  const Vec3 margin = 4 * face_tolerance * (high - low);
  return ((low - margin).array() <= 0).all() && ((high + margin).array() >= 0).all();
}

/// a(s, tau) - b(t, tau)
Trilinear distance_between(const MovingSegment& a, const MovingSegment& b) {
  const Vec3 offset = a.start.start - b.start.start;
  return {.one = offset,
          .u = direction(a.start),
          .v = -direction(b.start),
          .tau = (a.end.start - b.end.start) - offset,
          .u_tau = direction(a.end) - direction(a.start),
          .v_tau = direction(b.start) - direction(b.end)};
}

}  // namespace

std::optional<CommonPerpendicular> crossing_along(const Segment& a, const Segment& b, const Vec3& seen, double kink) {
  const auto p = feet_along(a, b, seen, parallel_sine);
  if (!p || !std::isfinite(p->s) || !std::isfinite(p->t)) return std::nullopt;
  CommonPerpendicular result{.s = std::clamp(p->s, 0.0, 1.0), .t = std::clamp(p->t, 0.0, 1.0)};
  result.on_a = point_at(a, result.s);
  result.on_b = point_at(b, result.t);
  result.normal = seen;
  result.gap = (point_at(a, p->s) - point_at(b, p->t)).dot(seen);
  result.past_an_end = !inside(p->s, face_tolerance) || !inside(p->t, face_tolerance);
  if (!result.past_an_end) return result;
  const double sine = direction(a).normalized().cross(direction(b).normalized()).norm();
  const double beside = (result.on_a - result.on_b - result.gap * result.normal).norm();
  if (!(beside <= kink * sine * std::abs(result.gap))) return std::nullopt;
  return result;
}

std::optional<EdgeCrossing> edge_crossing(const MovingSegment& a, const MovingSegment& b) {
  if (!may_meet(a, b)) return std::nullopt;
  const Trilinear distance = distance_between(a, b);
  constexpr double t = face_tolerance;
  const TrilinearDomain domain{.low = {-t, -t, -step_tolerance}, .high = {1 + t, 1 + t, 1 + step_tolerance}};
  const auto zero = first_zero(distance, domain, Crossing::either);
  if (!zero) return std::nullopt;
  const Vec3 p = derivative_u(distance, *zero), q = -derivative_v(distance, *zero), normal = p.cross(q);
  if (!(normal.norm() >= parallel_sine * p.norm() * q.norm())) return std::nullopt;

  EdgeCrossing result{.tau = std::clamp(zero->tau, 0.0, 1.0),
                      .s = std::clamp(zero->u, 0.0, 1.0),
                      .t = std::clamp(zero->v, 0.0, 1.0),
                      .along_a = along(zero->u, t),
                      .along_b = along(zero->v, t)};
  const Segment a_then{(1 - result.tau) * a.start.start + result.tau * a.end.start,
                       (1 - result.tau) * a.start.end + result.tau * a.end.end};
  result.point = point_at(a_then, result.s);
  result.normal = normal.normalized();
  if (derivative_tau(distance, *zero).dot(normal) > 0) result.normal = -result.normal;
  return result;
}

}  // namespace brunt::geometry
