// SPDX-License-Identifier: Apache-2.0
#include "flat_edges.hpp"

#include <Eigen/Geometry>
#include <algorithm>

#include "contact/data/tolerances.hpp"
#include "contact/detection/seams.hpp"

namespace brunt::contact {
namespace {

/// The meeting at the start of the step.
std::optional<EdgeMeeting> cross_now(const EdgeScene& scene, const EdgePair& pair, const Vec3& normal) {
  const auto crossing = geometry::crossing_along(scene.start(pair.slave), scene.start(pair.master), normal);
  if (!crossing || crossing->past_an_end) return std::nullopt;
  const EdgeMeeting met{crossing->s, crossing->t, crossing->gap, crossing->normal};
  const bool in_reach = met.gap > 0 ? is_slow(scene, pair) : -met.gap <= max_penetration(scene, pair);
  return in_reach ? std::optional(met) : std::nullopt;
}

/// The meeting of edges whose paths cross within the step.
std::optional<EdgeMeeting> cross_in_step(const EdgeScene& scene, const EdgePair& pair, const Vec3& normal) {
  if (is_slow(scene, pair)) return std::nullopt;
  const auto hit = geometry::edge_crossing({scene.start(pair.slave), scene.end(pair.slave)},
                                           {scene.start(pair.master), scene.end(pair.master)});
  if (!hit || hit->normal.dot(normal) < scene.tolerances().facing) return std::nullopt;
  const double approach = -normal.dot(relative_displacement<&NodeMotion::predicted>(scene, pair, hit->s, hit->t));
  if (!(approach > 0)) return std::nullopt;
  return EdgeMeeting{hit->s, hit->t, hit->tau * approach, normal};
}

/// Share of the flat edge's length at its end on a rim of its own within which the rims are in contact instead.
double share_of_rim(const EdgeScene& scene, const ContactEdge& flat, const ContactEdge& rim, std::size_t end) {
  const double length = scene.length(flat);
  const auto [one, other] = flat.end_at_side[end];
  const bool seam = (one || other) && seams_count(scene.settings, rim.body, flat.body);
  return seam ? scene.tolerances().max_penetration(length, flat.element_depth) / length : scene.tolerances().rim;
}

}  // namespace

std::optional<EdgeMeeting> cross_rim(const EdgeScene& scene, const EdgePair& pair) {
  const bool slave_is_flat = pair.slave.flat;
  const ContactEdge &flat = slave_is_flat ? pair.slave : pair.master, &rim = slave_is_flat ? pair.master : pair.slave;
  if (are_nearly_parallel(scene, pair)) return std::nullopt;
  const Vec3 out = scene.outward(flat).normalized(), normal = slave_is_flat ? Vec3(-out) : out;
  if (!between_normals(scene, rim, -out, scene.tolerances().warp)) return std::nullopt;
  auto met = cross_now(scene, pair, normal);
  if (!met) met = cross_in_step(scene, pair, normal);
  if (!met) return std::nullopt;
  const double at = slave_is_flat ? met->s : met->t;
  const bool at_own_rim = (flat.end_on_rim[0] != 0 && at <= share_of_rim(scene, flat, rim, 0)) ||
                          (flat.end_on_rim[1] != 0 && 1 - at <= share_of_rim(scene, flat, rim, 1));
  return at_own_rim ? std::nullopt : met;
}

}  // namespace brunt::contact
