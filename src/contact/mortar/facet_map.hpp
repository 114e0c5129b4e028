// SPDX-License-Identifier: Apache-2.0
// Shape functions of a facet in the plane, and their gradients, at points of the plane: the inverse of its bilinear
// map.
#pragma once
#include <algorithm>
#include <limits>

#include "core/simd.hpp"
#include "geometry/clip.hpp"

namespace brunt::contact {

/// x = mean + xi along_xi + eta along_eta + xi eta twist, of a quadrilateral over [-1, 1]^2; of a triangle from its
/// first corner, xi and eta the weights of the others. Counter-clockwise.
struct FacetMap {
  int corners = 0;
  geometry::PlanePoint<double> mean{}, along_xi{}, along_eta{}, twist{};

  explicit FacetMap(geometry::Polygon<double> p) : corners(static_cast<int>(p.size())) {
    if (corners == 3) {
      mean = p[0];
      along_xi = p[1] - p[0];
      along_eta = p[2] - p[0];
      return;
    }
    const auto combine = [&](double b, double c, double d) -> geometry::PlanePoint<double> {
      return {0.25 * (p[0].x + b * p[1].x + c * p[2].x + d * p[3].x),
              0.25 * (p[0].y + b * p[1].y + c * p[2].y + d * p[3].y)};
    };
    mean = combine(1, 1, 1);
    const auto against_xi = combine(-1, -1, 1), against_eta = combine(1, -1, -1);
    along_xi = {-against_xi.x, -against_xi.y};
    along_eta = {-against_eta.x, -against_eta.y};
    twist = combine(-1, 1, -1);
  }
};

/// One point in each lane; the fourth function of a triangle is zero.
struct ShapeFunctions {
  Pack value[4], by_x[4], by_y[4];
};

BRUNT_INLINE void triangle_functions(const FacetMap& map, Pack x, Pack y, ShapeFunctions& shape) {
  const auto [bx, by] = map.along_xi;
  const auto [cx, cy] = map.along_eta;
  const double over = 1 / (bx * cy - by * cx);
  const Pack hx = x - map.mean.x, hy = y - map.mean.y;
  shape.value[1] = over * (hx * cy - hy * cx);
  shape.value[2] = over * (hy * bx - hx * by);
  shape.value[0] = 1.0 - shape.value[1] - shape.value[2];
  shape.value[3] = Pack{};
  const double gradient[4][2] = {
      {over * (by - cy), over * (cx - bx)}, {over * cy, -over * cx}, {-over * by, over * bx}, {0, 0}};
  for (int a = 0; a < 4; ++a) {
    shape.by_x[a] = broadcast(gradient[a][0]);
    shape.by_y[a] = broadcast(gradient[a][1]);
  }
}

/// The root of b t - a t^2 = q at which the left side rises, without cancellation; b < 0 only in folded facets.
BRUNT_INLINE Pack quadratic_root(Pack a, Pack b, Pack q) {
  const Pack root = pack_sqrt(pack_max(b * b - 4.0 * a * q, Pack{}));
  const Pack least = broadcast(std::numeric_limits<double>::min());
  return select(b < 0.0, 0.5 * (b - root) / a, 2.0 * q / pack_max(b + root, least));
}

/// Both coordinates are roots of quadratic equations (the residual crossed with either tangent), the ones at which the
/// map keeps its orientation; a Newton step removes their rounding.
BRUNT_INLINE void quadrilateral_functions(const FacetMap& map, Pack x, Pack y, ShapeFunctions& shape) {
  const auto [bx, by] = map.along_xi;
  const auto [cx, cy] = map.along_eta;
  const auto [dx, dy] = map.twist;
  const Pack hx = x - map.mean.x, hy = y - map.mean.y;
  const double b_c = bx * cy - by * cx, b_d = bx * dy - by * dx, c_d = cx * dy - cy * dx;
  const Pack h_d = hx * dy - hy * dx;
  Pack xi = quadratic_root(broadcast(-b_d), b_c - h_d, hx * cy - hy * cx);
  Pack eta = quadratic_root(broadcast(c_d), b_c + h_d, hy * bx - hx * by);
  const Pack tx = bx + eta * dx, ty = by + eta * dy, ux = cx + xi * dx, uy = cy + xi * dy;  // tangents
  const Pack over = 1.0 / (tx * uy - ty * ux);
  const Pack xi_x = over * uy, xi_y = -over * ux, eta_x = -over * ty, eta_y = over * tx;
  const Pack rx = hx - xi * tx - eta * cx, ry = hy - xi * ty - eta * cy;
  xi += xi_x * rx + xi_y * ry;
  eta += eta_x * rx + eta_y * ry;
  constexpr double side[4][2] = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
  for (int a = 0; a < 4; ++a) {
    const double s = side[a][0], t = side[a][1];
    const Pack of_xi = 0.5 + 0.5 * s * xi, of_eta = 0.5 + 0.5 * t * eta;
    shape.value[a] = of_xi * of_eta;
    shape.by_x[a] = 0.5 * (s * of_eta * xi_x + t * of_xi * eta_x);
    shape.by_y[a] = 0.5 * (s * of_eta * xi_y + t * of_xi * eta_y);
  }
}

BRUNT_INLINE void shape_functions(const FacetMap& map, Pack x, Pack y, ShapeFunctions& shape) {
  if (map.corners == 3)
    triangle_functions(map, x, y, shape);
  else
    quadrilateral_functions(map, x, y, shape);
}

}  // namespace brunt::contact
