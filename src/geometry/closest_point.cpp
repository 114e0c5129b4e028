// SPDX-License-Identifier: Apache-2.0
// Closest point on a bilinear quadrilateral or a triangle: Newton, then edges, then sampling as a fallback.
#include "geometry/closest_point.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

namespace brunt::geometry {
namespace {

using Weights = std::array<double, 4>;
using QuadCorners = std::span<const Vec3, 4>;

// Most of the time of contact is spent here, about a hundred nanoseconds for each face: the steps on a quadrilateral
// are unrolled (a fixed number of corners) and inlined.
#define BRUNT_IN_PLACE [[gnu::always_inline]] inline

BRUNT_IN_PLACE Weights quad_weights(double xi, double eta) {
  return {0.25 * (1 - xi) * (1 - eta), 0.25 * (1 + xi) * (1 - eta), 0.25 * (1 + xi) * (1 + eta),
          0.25 * (1 - xi) * (1 + eta)};
}

template <std::size_t count>
BRUNT_IN_PLACE Vec3 combine(std::span<const Vec3, count> corners, const Weights& weights) {
  Vec3 point = Vec3::Zero();
  for (std::size_t i = 0; i < corners.size(); ++i) point += weights[i] * corners[i];
  return point;
}

struct Tangents {
  Vec3 xi, eta;
};

template <std::size_t count>
BRUNT_IN_PLACE Tangents tangents(std::span<const Vec3, count> c, double xi, double eta) {
  if (c.size() == 3) return {c[1] - c[0], c[2] - c[0]};
  return {0.25 * ((1 - eta) * (c[1] - c[0]) + (1 + eta) * (c[2] - c[3])),
          0.25 * ((1 - xi) * (c[3] - c[0]) + (1 + xi) * (c[2] - c[1]))};
}

FacePoint face_point(Corners corners, double xi, double eta, Region region) {
  FacePoint result{.xi = xi, .eta = eta, .weights = face_weights(corners.size(), xi, eta), .region = region};
  result.point = combine(corners, result.weights);
  return result;
}

/// Signed by the side of the edge of the point; proportional to the area between the two.
BRUNT_IN_PLACE double edge_area(const Vec3& x, const Vec3& from, const Vec3& to, const Vec3& normal) {
  return normal.dot((to - from).cross(x - from));
}

struct Parameters {
  double xi = 0, eta = 0;
};

BRUNT_IN_PLACE double area_ratio(double low_side, double high_side) {
  const double sum = low_side + high_side;
  return sum > 0 ? std::clamp((low_side - high_side) / sum, -1.5, 1.5) : 0.0;
}

/// area: of the face; its magnitude cancels in the ratios.
BRUNT_IN_PLACE Parameters seed(const Vec3& x, QuadCorners c, const Vec3& area) {
  return {area_ratio(edge_area(x, c[3], c[0], area), edge_area(x, c[1], c[2], area)),
          area_ratio(edge_area(x, c[0], c[1], area), edge_area(x, c[2], c[3], area))};
}

/// Unconstrained stationary point; none if ten steps do not converge. On a nearly flat face Newton's method does not
/// diverge: an iterate far outside indicates a point far outside, and the nearest edge is then used.
BRUNT_IN_PLACE std::optional<Parameters> newton(const Vec3& x, QuadCorners c, Parameters p) {
  constexpr int max_steps = 10;
  constexpr double lost = 4.0;
  const Vec3 twist = 0.25 * (c[0] - c[1] + c[2] - c[3]);
  const Tangents middle = tangents(c, 0, 0);
  const bool nearly_flat = twist.squaredNorm() < 0.01 * std::min(middle.xi.squaredNorm(), middle.eta.squaredNorm());
  for (int step = 0; step < max_steps; ++step) {
    const Tangents t = tangents(c, p.xi, p.eta);
    const Vec3 offset = x - combine(c, quad_weights(p.xi, p.eta));
    const double a = t.xi.squaredNorm(), b = t.eta.squaredNorm();
    double mixed = t.xi.dot(t.eta) - offset.dot(twist);
    double settled = 1e-7;                        // the remaining error is the square of the step
    if (a * b - mixed * mixed <= 0.05 * a * b) {  // Gauss-Newton if the Hessian is not positive definite
      mixed = t.xi.dot(t.eta);
      settled = 1e-13;
    }
    const double determinant = a * b - mixed * mixed;
    if (!(determinant > 1e-12 * a * b)) return std::nullopt;
    const double f = t.xi.dot(offset), g = t.eta.dot(offset);
    const double d_xi = (b * f - mixed * g) / determinant, d_eta = (a * g - mixed * f) / determinant;
    p.xi += d_xi;
    p.eta += d_eta;
    if (!(std::abs(p.xi) < lost && std::abs(p.eta) < lost))
      return nearly_flat && std::isfinite(p.xi) && std::isfinite(p.eta) ? std::optional(p) : std::nullopt;
    if (std::abs(d_xi) + std::abs(d_eta) < settled) return p;
    if (step + 1 == max_steps && std::abs(d_xi) + std::abs(d_eta) < 1e-10) return p;
  }
  return std::nullopt;
}

struct EdgePoint {
  double along = 0;  ///< 0 at the first corner, 1 at the second
  double distance2 = std::numeric_limits<double>::infinity();
  std::size_t edge = 0;
};

template <std::size_t count>
BRUNT_IN_PLACE EdgePoint nearest_edge(const Vec3& x, std::span<const Vec3, count> c) {
  EdgePoint best;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t edge = 0; edge < c.size(); ++edge) {
    const Vec3 &from = c[edge], &to = c[(edge + 1) % c.size()];
    const double length2 = (to - from).squaredNorm();
    const double along = length2 > 0 ? std::clamp((x - from).dot(to - from) / length2, 0.0, 1.0) : 0.0;
    const double distance2 = (x - ((1 - along) * from + along * to)).squaredNorm();
    const double rank = along > 0 && along < 1 ? distance2 : distance2 * (1 + 1e-15);  // of equal ones, the edge
    if (rank < least) {
      least = rank;
      best = {along, distance2, edge};
    }
  }
  return best;
}

Region region_of(const EdgePoint& at, std::size_t corner_count) {
  constexpr int first_edge = static_cast<int>(Region::edge0), first_vertex = static_cast<int>(Region::vertex0);
  if (at.along <= 0) return static_cast<Region>(first_vertex + static_cast<int>(at.edge));
  if (at.along >= 1) return static_cast<Region>(first_vertex + static_cast<int>((at.edge + 1) % corner_count));
  return static_cast<Region>(first_edge + static_cast<int>(at.edge));
}

FacePoint on_edge(Corners c, const EdgePoint& at) {
  const Region region = region_of(at, c.size());
  const double s = at.along;
  if (c.size() == 3) {
    const std::array<Parameters, 3> place{{{s, 0}, {1 - s, s}, {0, 1 - s}}};
    return face_point(c, place[at.edge].xi, place[at.edge].eta, region);
  }
  const std::array<Parameters, 4> place{{{2 * s - 1, -1}, {1, 2 * s - 1}, {1 - 2 * s, 1}, {-1, 1 - 2 * s}}};
  return face_point(c, place[at.edge].xi, place[at.edge].eta, region);
}

/// Best point of a grid, refined repeatedly around the best one: slow, but it always ends and never leaves the face.
FacePoint by_sampling(const Vec3& x, Corners c) {
  constexpr int half = 4;
  Parameters best;
  double best_distance2 = std::numeric_limits<double>::infinity(), spacing = 1.0 / half;
  while (spacing > 1e-13) {
    const Parameters centre = best;
    for (int i = -half; i <= half; ++i) {
      for (int j = -half; j <= half; ++j) {
        const Parameters p{std::clamp(centre.xi + i * spacing, -1.0, 1.0),
                           std::clamp(centre.eta + j * spacing, -1.0, 1.0)};
        const double distance2 = (x - combine(c, face_weights(4, p.xi, p.eta))).squaredNorm();
        if (distance2 < best_distance2) {
          best_distance2 = distance2;
          best = p;
        }
      }
    }
    spacing *= 0.4;
  }
  const EdgePoint edge = nearest_edge(x, c);
  const bool on_rim = std::max(std::abs(best.xi), std::abs(best.eta)) >= 1;  // by rounding it may appear nearer there
  if (on_rim || edge.distance2 <= best_distance2) return on_edge(c, edge);
  return face_point(c, best.xi, best.eta, Region::face);
}

BRUNT_IN_PLACE double longest_edge2(Corners corners) {
  double longest2 = 0;
  for (std::size_t i = 0; i < corners.size(); ++i)
    longest2 = std::max(longest2, (corners[i + 1 < corners.size() ? i + 1 : 0] - corners[i]).squaredNorm());
  return longest2;
}

bool inside(const Parameters& p, double reach) {
  return std::abs(p.xi) <= reach && std::abs(p.eta) <= reach;
}

FacePoint on_quad(const Vec3& x, QuadCorners c, const Vec3& area) {
  constexpr double reach = 1 + 2 * face_tolerance;  // the parametric width is 2
  std::optional<Parameters> p = newton(x, c, seed(x, c, area));
  if (!p) {  // squared distances determine a position to half the digits only: refine by Newton
    FacePoint sampled = by_sampling(x, c);
    p = newton(x, c, {sampled.xi, sampled.eta});
    if (sampled.region != Region::face || !p || !inside(*p, reach)) return sampled;
  }
  if (!inside(*p, reach)) return on_edge(c, nearest_edge(x, c));
  return face_point(c, std::clamp(p->xi, -1.0, 1.0), std::clamp(p->eta, -1.0, 1.0), Region::face);
}

FacePoint on_triangle(const Vec3& x, Corners c, const Vec3& area) {
  const double twice = 2 * area.norm();
  const Vec3 n = area.normalized();
  const double w1 = edge_area(x, c[2], c[0], n) / twice, w2 = edge_area(x, c[0], c[1], n) / twice;
  if (std::min({w1, w2, 1 - w1 - w2}) < -face_tolerance) return on_edge(c, nearest_edge(x, c));
  const double xi = std::max(w1, 0.0), eta = std::max(w2, 0.0), sum = std::max(xi + eta, 1.0);
  return face_point(c, xi / sum, eta / sum, Region::face);
}

}  // namespace

std::array<double, 4> face_weights(std::size_t corner_count, double xi, double eta) {
  if (corner_count == 3) return {1 - xi - eta, xi, eta, 0};
  return quad_weights(xi, eta);
}

Vec3 face_normal(Corners corners, double xi, double eta) {
  const Tangents t = tangents(corners, xi, eta);
  const Vec3 cross = t.xi.cross(t.eta);
  const double floor = 1e-12 * (t.xi.squaredNorm() + t.eta.squaredNorm());
  return cross.norm() > floor ? cross.normalized() : area_vector(corners).normalized();
}

double longest_edge(Corners corners) {
  return std::sqrt(longest_edge2(corners));
}

double width(Corners corners) {
  const double edge = longest_edge(corners), area = area_vector(corners).norm();
  return edge > 0 ? (corners.size() == 3 ? 2 : 1) * area / edge : 0.0;
}

std::optional<FacePoint> closest_point(const Vec3& x, Corners corners) {
  const Vec3 area = area_vector(corners);
  const double edge2 = longest_edge2(corners);
  if (!x.allFinite() || !(area.squaredNorm() > 1e-24 * edge2 * edge2)) return std::nullopt;
  return corners.size() == 3 ? on_triangle(x, corners, area) : on_quad(x, QuadCorners(corners), area);
}

#undef BRUNT_IN_PLACE

}  // namespace brunt::geometry
