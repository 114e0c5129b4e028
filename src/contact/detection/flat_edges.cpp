// SPDX-License-Identifier: Apache-2.0
#include "flat_edges.hpp"

#include <Eigen/Geometry>
#include <algorithm>

#include "contact/data/tolerances.hpp"
#include "contact/detection/seams.hpp"

namespace brunt::contact {
namespace {

bool crosses_now(const EdgeScene& scene, const ContactEdge& slave, const ContactEdge& master, const Vec3& normal,
                 double size, EdgeMeeting& met) {
  const auto crossing = geometry::crossing_along(scene.start(slave), scene.start(master), normal);
  if (!crossing || crossing->past_an_end) return false;
  met = {crossing->s, crossing->t, crossing->gap, crossing->normal};
  if (met.gap > 0) return is_slow(scene, slave, master, size);
  return -met.gap <= scene.tolerances().max_penetration(size, std::min(slave.element_depth, master.element_depth));
}

bool crosses_in_step(const EdgeScene& scene, const ContactEdge& slave, const ContactEdge& master, const Vec3& normal,
                     double size, EdgeMeeting& met) {
  if (is_slow(scene, slave, master, size)) return false;
  const auto hit =
      geometry::edge_crossing({scene.start(slave), scene.end(slave)}, {scene.start(master), scene.end(master)});
  if (!hit || hit->normal.dot(normal) < scene.tolerances().facing) return false;
  const double approach = -normal.dot(relative_displacement(scene, slave, master, hit->s, hit->t));
  met = {hit->s, hit->t, hit->tau * approach, normal};
  return approach > 0;
}

/// How far from its end at a rim a flat edge is met as that, as a share of its length.
double rim_at(const EdgeScene& scene, const ContactEdge& flat, const ContactEdge& rim, std::size_t end) {
  const double length = scene.length(flat);
  const auto [one, other] = flat.end_at_side[end];
  const bool seam = (one || other) && seams_count(scene.settings, rim.body, flat.body);
  return seam ? scene.tolerances().max_penetration(length, flat.element_depth) / length : scene.tolerances().rim;
}

}  // namespace

bool rim_crosses_flat(const EdgeScene& scene, const ContactEdge& slave, const ContactEdge& master, double size,
                      EdgeMeeting& met) {
  const ContactEdge &flat = slave.flat ? slave : master, &rim = slave.flat ? master : slave;
  if (scene.start(slave).along().cross(scene.start(master).along()).norm() < scene.full) return false;
  const Vec3 out = scene.outward(flat).normalized(), normal = slave.flat ? Vec3(-out) : out;
  if (!between_normals(scene, rim, -out, scene.tolerances().warp)) return false;
  if (!crosses_now(scene, slave, master, normal, size, met) &&
      !crosses_in_step(scene, slave, master, normal, size, met))
    return false;
  const double at = slave.flat ? met.s : met.t;
  return !(flat.end_on_rim[0] != 0 && at <= rim_at(scene, flat, rim, 0)) &&
         !(flat.end_on_rim[1] != 0 && 1 - at <= rim_at(scene, flat, rim, 1));
}

}  // namespace brunt::contact
