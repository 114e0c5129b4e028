// SPDX-License-Identifier: Apache-2.0
#include "flat_edges.hpp"

#include <Eigen/Geometry>
#include <algorithm>

namespace brunt::contact {
namespace {

constexpr double sag = 1e-3;        // of the shorter edge
constexpr double along_a_face = 5;  // [degrees] from a face's normal: the node lies on it
constexpr double crosswise = 0.35;  // cosine between directions that lie across each other, at most
constexpr double same_side = 0.5;   // cosine between the normal of a path's crossing and the face's, at least

bool crosses_now(const EdgeScene& scene, const EdgeSide& slave, const EdgeSide& master, const Vec3& normal, double size,
                 EdgeMeeting& met) {
  const auto crossing = geometry::crossing_along(scene.start(slave), scene.start(master), normal);
  if (!crossing || crossing->past_an_end) return false;
  met = {crossing->s, crossing->t, crossing->gap, crossing->normal};
  if (met.gap > 0) return is_slow(scene, slave, master, size);
  return -met.gap <= scene.settings.encounter.deepest(size, std::min(slave.depth, master.depth));
}

bool crosses_in_step(const EdgeScene& scene, const EdgeSide& slave, const EdgeSide& master, const Vec3& normal,
                     double size, EdgeMeeting& met) {
  if (is_slow(scene, slave, master, size)) return false;
  const auto hit =
      geometry::edge_crossing({scene.start(slave), scene.end(slave)}, {scene.start(master), scene.end(master)});
  if (!hit || hit->normal.dot(normal) < same_side) return false;
  const double approach = -normal.dot(relative_motion(scene, slave, master, hit->s, hit->t));
  met = {hit->s, hit->t, hit->tau * approach, normal};
  return approach > 0;
}

}  // namespace

bool rim_crosses_flat(const EdgeScene& scene, std::span<const Vec3> node_normal, const EdgeSide& slave,
                      const EdgeSide& master, double size, EdgeMeeting& met) {
  const EdgeSide &flat = slave.flat ? slave : master, &rim = slave.flat ? master : slave;
  if (scene.start(slave).along().cross(scene.start(master).along()).norm() < scene.full) return false;
  const Vec3 out = scene.outward(flat).normalized(), normal = slave.flat ? Vec3(-out) : out;
  if (!between_normals(scene, rim, -out, warp)) return false;
  if (!crosses_now(scene, slave, master, normal, size, met) &&
      !crosses_in_step(scene, slave, master, normal, size, met))
    return false;
  const double at_flat = slave.flat ? met.s : met.t, at_rim = slave.flat ? met.t : met.s;
  const double reach = scene.settings.encounter.rim;
  const bool at_node = std::min(at_flat, 1 - at_flat) <= reach;
  if (at_node && !between_normals(scene, rim, -out, -warp)) return false;

  const auto normal_of = [&](const EdgeSide& edge, std::size_t end) -> const Vec3& {
    return node_normal[static_cast<std::size_t>(edge.nodes[end])];
  };
  const auto lies_on_face = [&](std::size_t end) { return same_direction(normal_of(rim, end), out, along_a_face); };
  const auto is_under_rim = [&](std::size_t end) { return -normal_of(flat, end).dot(out) > crosswise; };
  const bool held = lies_on_face(0) || lies_on_face(1) || is_under_rim(0) || is_under_rim(1);
  if (held && met.gap > -sag * size) return false;
  const std::size_t end = at_rim < 0.5 ? 0 : 1;
  return !(std::min(at_rim, 1 - at_rim) <= reach && normal_of(rim, end).dot(out) > crosswise);
}

}  // namespace brunt::contact
