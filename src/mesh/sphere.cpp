// SPDX-License-Identifier: Apache-2.0
// A solid sphere: a ball of cells, drawn towards its lowest point.
#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "ball.hpp"
#include "draw_down.hpp"
#include "hex_body.hpp"
#include "mesh/primitives.hpp"

namespace brunt::mesh {
namespace {

/// The conformal map of the ball of this radius onto itself that shrinks what is at the lowest point by `finer`, and
/// widens as much what is at the highest (a translation of hyperbolic space). Planes x = 0, y = 0 stay.
Vec3 draw_down(const Vec3& x, double radius, double finer) {
  const Vec3 p = x / radius, a(0, 0, -(finer - 1) / (finer + 1));
  const double along = 1 + 2 * a.dot(p), p2 = p.squaredNorm(), a2 = a.squaredNorm();
  return radius * ((along + p2) * a + (1 - a2) * p) / (along + a2 * p2);
}

/// The same within the half ball z <= 0: its plane stays, and elements are smaller by `finer` at the lowest point
/// alone. The map above multiplies the ratio t of a point's distances from lowest and highest point by 1/finer; this
/// one by (1 + (finer - 1) t^2) / finer, which is 1 in the plane, where t = 1. Along a line from pole to plane, lengths
/// are stretched against those across it by d ln t' / d ln t, from 1 at the pole to below 3 in the plane.
Vec3 draw_down_half(const Vec3& x, double radius, double finer) {
  if (x[2] == 0) return x;
  const double p2 = x.squaredNorm() / (radius * radius), z = x[2] / radius;
  const double t2 = (1 + p2 + 2 * z) / (1 + p2 - 2 * z);
  return draw_down(x, radius, finer / (1 + (finer - 1) * t2));
}

}  // namespace

void check_sphere(const std::string& part, double radius, int elements, const SphereForm& form) {
  ParameterCheck check("sphere " + part);
  check.positive("radius", radius);
  check.holds(std::isfinite(form.finer) && form.finer >= 1,
              fmt::format("out of range: finer is {}; expected a number >= 1", form.finer));
  check.holds(
      form.finer == 1 || form.half[2] <= 0,
      "invalid half z with finer: this half keeps the pole that is not refined; expected -z, or no half along z");
  check.at_least("elements across the radius", elements, 2);
  check.fits(24.0 * elements * elements * elements);
  check.finish();
}

void draw_down(std::vector<Vec3>& coordinates, double radius, const SphereForm& form) {
  if (form.finer == 1) return;
  for (Vec3& x : coordinates)
    x = form.half[2] != 0 ? draw_down_half(x, radius, form.finer) : draw_down(x, radius, form.finer);
}

Mesh sphere(const std::string& part, double radius, int elements, const SphereForm& form) {
  check_sphere(part, radius, elements, form);
  Ball solid = ball(RoundedCore(radius, elements), form.half);
  const LocalIndex inner = solid.inner;
  std::vector<SurfaceSet> sets{{part + "_surface", [=](LocalIndex n) { return n >= inner; }}};
  Mesh mesh = hex_body(part, std::move(solid.cells));
  add_cut_planes(mesh, part, form.half, sets);  // before the map, which keeps these planes to rounding
  draw_down(mesh.coordinates, radius, form);
  add_surface_sets(mesh, sets);
  return mesh;
}

}  // namespace brunt::mesh
