// SPDX-License-Identifier: Apache-2.0
#include "contact/detection/edges.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "contact/data/tolerances.hpp"
#include "contact/detection/seams.hpp"
#include "edge_ledges.hpp"
#include "flat_edges.hpp"

namespace brunt::contact {
namespace {

bool touches_as_edges(const EdgeScene& scene, const ContactEdge& slave, const ContactEdge& master, const Vec3& normal,
                      double beyond) {
  return between_normals(scene, master, normal, beyond) && between_normals(scene, slave, -normal, beyond);
}

/// What of a direction is across an edge.
Vec3 across(const Vec3& direction, const geometry::Segment& edge) {
  const Vec3 along = edge.along();
  return (direction - direction.dot(along) * along).normalized();
}

/// Axes of two edges: the middle between them, their common perpendicular, and what is across both.
Mat3 axes_of(const geometry::Segment& one, const geometry::Segment& two) {
  const Vec3 first = one.along(), second = two.along();
  Mat3 axes;
  axes.col(0) = (first + (first.dot(second) < 0 ? -1 : 1) * second).normalized();
  axes.col(1) = first.cross(second).normalized();
  axes.col(2) = axes.col(0).cross(axes.col(1));
  return axes;
}

/// The crossing of two edges as seen along their common perpendicular. The smaller their angle, the more this direction
/// rotates when one of them tilts, and the farther the crossing moves: impulses along it would amplify both. Nearly
/// parallel edges are therefore projected along the mean of their faces' normals. This direction may change from edge
/// to edge of a chain, so that the crossing lies on neither: then the normals of each side alone are used, which the
/// edges of the other side's chain have in common.
std::optional<geometry::CommonPerpendicular> crossing(const EdgeScene& scene, const ContactEdge& slave,
                                                      const ContactEdge& master) {
  const geometry::Segment own = scene.start(slave), other = scene.start(master);
  const Vec3 out_of_slave = scene.outward(slave), out_of_master = scene.outward(master);
  const Vec3 apart = out_of_master - out_of_slave;
  Vec3 perpendicular = own.along().cross(other.along());
  if (perpendicular.dot(apart) < 0) perpendicular = -perpendicular;
  const double sine = perpendicular.norm();
  const double full = scene.full;
  if (sine >= full) return geometry::crossing_along(own, other, perpendicular.normalized(), scene.tolerances().kink);
  const Vec3 mean = axes_of(own, other).col(0);
  const Vec3 middle = (apart - apart.dot(mean) * mean).normalized();
  const Vec3 between = (sine / full * perpendicular + (full - sine) * middle).normalized();
  for (const Vec3& direction : {between, across(-out_of_slave, own), across(out_of_master, other)})
    if (auto met = geometry::crossing_along(own, other, direction); met) return met;
  return std::nullopt;
}

/// In contact or near each other, at the start of the step.
bool meet_now(const EdgeScene& scene, const ContactEdge& slave, const ContactEdge& master, double size,
              EdgeMeeting& met) {
  const Tolerances& tolerances = scene.tolerances();
  const auto closest = crossing(scene, slave, master);
  if (!closest) return false;
  met = {closest->s, closest->t, closest->gap, closest->normal};
  // a node that contact holds presses a chain in by little: deep ones pass each other beside the end of one
  if (closest->past_an_end && -met.gap > tolerances.rim * size) return false;
  // edges that hold each other would let go for a step wherever their normal passes the mean normal of a warped face
  const bool shallow = std::abs(met.gap) <= tolerances.rim * size;
  // where a chain of edges ends for good, faces and nodes meet, along the normal of a face
  const double beyond =
      closest->past_an_end ? -tolerances.warp : (shallow ? tolerances.warp : tolerances.facet_curvature);
  if (!touches_as_edges(scene, slave, master, met.normal, beyond)) return false;
  if (met.gap <= 0)
    return -met.gap <= tolerances.max_penetration(size, std::min(slave.element_depth, master.element_depth));
  return is_slow(scene, slave, master, size);
}

/// Their paths cross within the step.
bool meet_in_step(const EdgeScene& scene, const ContactEdge& slave, const ContactEdge& master, EdgeMeeting& met) {
  const auto hit =
      geometry::edge_crossing({scene.start(slave), scene.end(slave)}, {scene.start(master), scene.end(master)});
  if (!hit) return false;
  const double approach = -hit->normal.dot(relative_displacement(scene, slave, master, hit->s, hit->t));
  if (!(approach > 0) || !touches_as_edges(scene, slave, master, hit->normal, scene.tolerances().facet_curvature))
    return false;
  met = {hit->s, hit->t, hit->tau * approach, hit->normal};
  return true;
}

/// Whether the ends of the slave edge have rows of their own that constrain it. Along nearly the same normal the edge
/// lies in a face. An end beyond the master's rim has none, and the row of an end whose face is inclined is less deep
/// than the edge at the rim. If an end lies deep, its own row gives the penetration. A deep edge with both ends
/// constrained in a perpendicular direction has entered from that side, over the end of the master's edge. Rows with
/// other bodies hold nothing off this one: plates that lie across several others meet each of them.
bool held_at_ends(const Tolerances& tolerances, std::span<const NodeHold> holds, const ContactEdge& slave,
                  const ContactEdge& master, double size, const EdgeMeeting& met) {
  const bool deep = -met.gap > tolerances.rim * size;
  const auto normal_of = [&](std::size_t end) -> Vec3 {
    const NodeHold& hold = holds[static_cast<std::size_t>(slave.nodes[end])];
    return hold.is_on(master.body) ? hold.normal : Vec3::Zero();
  };
  const auto held = [&](std::size_t end, double weight) {
    const Vec3 normal = normal_of(end);
    if (deep && weight >= 1 - tolerances.rim) return !normal.isZero(0);
    return weight <= tolerances.rim || same_direction(normal, met.normal, tolerances.blunt_angle);
  };
  const auto held_across = [&](std::size_t end) {
    const Vec3 normal = normal_of(end);
    return !normal.isZero(0) && std::abs(normal.dot(met.normal)) < tolerances.facing;
  };
  return (held(0, 1 - met.s) && held(1, met.s)) || (deep && held_across(0) && held_across(1));
}

/// The meeting along another normal; false if they do not meet along it.
bool turn_to(const Vec3& normal, const EdgeScene& scene, const ContactEdge& slave, const ContactEdge& master,
             EdgeMeeting& met) {
  const auto along = geometry::crossing_along(scene.start(slave), scene.start(master), normal);
  if (along) met = {along->s, along->t, along->gap, along->normal};
  return along.has_value();
}

bool has_accepted_end(const EdgeScene& scene, const ContactEdge& edge, std::int32_t body) {
  return std::ranges::any_of(edge.nodes, [&](LocalIndex node) {
    return accepted_penetration(scene.settings.accepted, scene.gid[static_cast<std::size_t>(node)], body) > 0;
  });
}

/// How deep the edges lay in each other at the start, on the sides on which they meet now, where the scene accepts
/// that.
double accepted_overlap(const EdgeScene& scene, const ContactEdge& slave, const ContactEdge& master,
                        const EdgeMeeting& met) {
  if (scene.reference.empty()) return 0;
  if (!has_accepted_end(scene, slave, master.body) && !has_accepted_end(scene, master, slave.body)) return 0;
  const auto then = [&](const ContactEdge& edge) {
    return geometry::Segment{scene.reference[static_cast<std::size_t>(edge.nodes[0])],
                             scene.reference[static_cast<std::size_t>(edge.nodes[1])]};
  };
  const geometry::Segment own = then(slave), other = then(master);
  const Mat3 turned = axes_of(own, other) * axes_of(scene.start(slave), scene.start(master)).transpose();
  const auto start = geometry::crossing_along(own, other, turned * met.normal, scene.tolerances().kink);
  return start ? std::max(0.0, -start->gap) : 0.0;
}

Row row_of(const ContactEdge& slave, const ContactEdge& master, const EdgeMeeting& met,
           std::span<const GlobalIndex> gid) {
  const auto id = [&](LocalIndex node) { return gid[static_cast<std::size_t>(node)]; };
  Row row{.key = {RowKind::edge, id(slave.nodes[0]), id(slave.nodes[1]), id(master.nodes[0]), id(master.nodes[1])}};
  row.nodes = {slave.nodes[0], slave.nodes[1], master.nodes[0], master.nodes[1], 0};
  row.weights = {1 - met.s, met.s, -(1 - met.t), -met.t, 0};
  row.node_count = 4;
  row.slave_body = slave.body;
  row.slave_block = slave.block;
  row.master_body = master.body;
  row.master_block = master.block;
  row.normal = met.normal;
  row.gap = met.gap;
  return row;
}

}  // namespace

void detect_edges(const EdgeCandidates& candidates, std::span<const GlobalIndex> gid,
                  std::span<const NodeMotion> motion, std::span<const Vec3> facet_normal,
                  std::span<const NodeHold> holds, std::span<const Vec3> reference, double dt,
                  const DetectionSettings& settings, std::vector<Row>& rows) {
  const double full = std::sin(settings.tolerances->same_direction * std::numbers::pi / 180);
  const EdgeScene scene{gid, motion, facet_normal, reference, dt, settings, full};
  for (std::size_t e = 0; e < candidates.slaves.size(); ++e) {
    const ContactEdge& slave = candidates.slaves[e];
    const geometry::Box slave_box = scene.sweep(slave);
    const std::span<const LocalIndex> near = candidates.near.row(static_cast<LocalIndex>(e));
    for (const LocalIndex m : near) {
      const ContactEdge& master = candidates.masters[static_cast<std::size_t>(m)];
      if (!geometry::overlaps(scene.reach(master), slave_box)) continue;
      const double size = std::min(scene.length(slave), scene.length(master));
      EdgeMeeting met;
      if (slave.flat || master.flat) {
        if (!rim_crosses_flat(scene, slave, master, size, met)) continue;
        if (meet_on_ledge(scene, candidates, near, holds, slave, master, met)) continue;
      } else {
        if (!meet_now(scene, slave, master, size, met) &&
            (is_slow(scene, slave, master, size) || !meet_in_step(scene, slave, master, met)))
          continue;
        if (meet_on_ledge(scene, candidates, near, holds, slave, master, met)) continue;
        if (held_at_ends(*settings.tolerances, holds, slave, master, size, met)) continue;
        if (const auto normal = face_below(scene, holds, slave, master);
            normal && !turn_to(*normal, scene, slave, master, met))
          continue;
      }
      if (meet_at_side_of_seam(scene, slave, master, met)) continue;
      met.gap += accepted_overlap(scene, slave, master, met);
      Row& row = rows.emplace_back(row_of(slave, master, met, gid));
      row.gap += slave.flat || master.flat ? settings.tolerances->ledge * size : 0;
      row.required = required_rate(row, size, dt, motion, settings);
      row.gap = met.gap;  // the reported gap is the geometric one
    }
  }
}

}  // namespace brunt::contact
