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

/// Whether the normal lies in the normal cones of both edges, or beyond them by at most the sine `beyond`.
bool in_both_cones(const EdgeScene& scene, const EdgePair& pair, const Vec3& normal, double beyond) {
  return between_normals(scene, pair.master, normal, beyond) && between_normals(scene, pair.slave, -normal, beyond);
}

/// Unit vector along the component of a direction perpendicular to an edge.
Vec3 across(const Vec3& direction, const geometry::Segment& edge) {
  const Vec3 along = edge.along();
  return (direction - direction.dot(along) * along).normalized();
}

/// Orthogonal axes of two edges: the mean of their directions, their common perpendicular, and the third axis.
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
/// to edge of a chain, so that the crossing lies on neither: then the normals of each body alone are used, which the
/// edges of the other body's chain have in common.
std::optional<geometry::CommonPerpendicular> crossing(const EdgeScene& scene, const EdgePair& pair) {
  const geometry::Segment own = scene.start(pair.slave), other = scene.start(pair.master);
  const Vec3 out_of_slave = scene.outward(pair.slave), out_of_master = scene.outward(pair.master);
  const Vec3 apart = out_of_master - out_of_slave;
  Vec3 perpendicular = own.along().cross(other.along());
  if (perpendicular.dot(apart) < 0) perpendicular = -perpendicular;
  const double sine = perpendicular.norm(), full = scene.sine_of_one_direction;
  if (sine >= full) return geometry::crossing_along(own, other, perpendicular.normalized(), scene.tolerances().kink);
  const Vec3 along = axes_of(own, other).col(0);
  const Vec3 middle = (apart - apart.dot(along) * along).normalized();
  const Vec3 blend = (sine / full * perpendicular + (full - sine) * middle).normalized();
  for (const Vec3& direction : {blend, across(-out_of_slave, own), across(out_of_master, other)})
    if (auto met = geometry::crossing_along(own, other, direction); met) return met;
  return std::nullopt;
}

/// The meeting at the start of the step: in contact or near each other.
std::optional<EdgeMeeting> meet_now(const EdgeScene& scene, const EdgePair& pair) {
  const Tolerances& tolerances = scene.tolerances();
  const auto closest = crossing(scene, pair);
  if (!closest) return std::nullopt;
  const EdgeMeeting met{closest->s, closest->t, closest->gap, closest->normal};
  // a node held by contact dents a chain of edges only slightly: deep edges pass beside the end of each other
  if (closest->past_an_end && -met.gap > tolerances.rim * pair.size) return std::nullopt;
  // edges in contact would separate for a step whenever their normal passes the mean normal of a warped face
  const bool shallow = std::abs(met.gap) <= tolerances.rim * pair.size;
  // at the end of a chain of edges, faces and nodes are in contact instead, along the normal of a face
  const double beyond =
      closest->past_an_end ? -tolerances.warp : (shallow ? tolerances.warp : tolerances.facet_curvature);
  if (!in_both_cones(scene, pair, met.normal, beyond)) return std::nullopt;
  const bool in_reach = met.gap <= 0 ? -met.gap <= max_penetration(scene, pair) : is_slow(scene, pair);
  return in_reach ? std::optional(met) : std::nullopt;
}

/// The meeting of edges whose paths cross within the step.
std::optional<EdgeMeeting> meet_in_step(const EdgeScene& scene, const EdgePair& pair) {
  const auto hit = geometry::edge_crossing({scene.start(pair.slave), scene.end(pair.slave)},
                                           {scene.start(pair.master), scene.end(pair.master)});
  if (!hit) return std::nullopt;
  const Vec3 relative = relative_displacement<&NodeMotion::predicted>(scene, pair, hit->s, hit->t);
  const double approach = -hit->normal.dot(relative);
  if (!(approach > 0) || !in_both_cones(scene, pair, hit->normal, scene.tolerances().facet_curvature))
    return std::nullopt;
  return EdgeMeeting{hit->s, hit->t, hit->tau * approach, hit->normal};
}

/// Whether the ends of the slave edge have rows of their own that constrain it. Along nearly the same normal the edge
/// lies in a face. An end beyond the master's rim has none, and the row of an end whose face is inclined is less deep
/// than the edge at the rim. If an end lies deep, its own row gives the penetration. A deep edge with both ends
/// constrained in a perpendicular direction has entered from that direction, over the end of the master's edge. Rows
/// with other bodies do not count: of plates that lie across several others, each pair is in contact.
bool is_held_at_ends(const EdgeScene& scene, const EdgePair& pair, const EdgeMeeting& met) {
  const Tolerances& tolerances = scene.tolerances();
  const bool deep = -met.gap > tolerances.rim * pair.size;
  const auto normal_of = [&](std::size_t end) -> Vec3 {
    const NodeHold& hold = scene.hold(pair.slave.nodes[end]);
    return hold.is_on(pair.master.body) ? hold.normal : Vec3::Zero();
  };
  const auto is_held = [&](std::size_t end, double weight) {
    const Vec3 normal = normal_of(end);
    if (deep && weight >= 1 - tolerances.rim) return !normal.isZero(0);
    return weight <= tolerances.rim || same_direction(normal, met.normal, tolerances.blunt_angle);
  };
  const auto is_held_across = [&](std::size_t end) {
    const Vec3 normal = normal_of(end);
    return !normal.isZero(0) && std::abs(normal.dot(met.normal)) < tolerances.facing;
  };
  return (is_held(0, 1 - met.s) && is_held(1, met.s)) || (deep && is_held_across(0) && is_held_across(1));
}

/// Whether an end of the edge has an accepted overlap with the body.
bool has_accepted_end(const EdgeScene& scene, const ContactEdge& edge, std::int32_t body) {
  return std::ranges::any_of(edge.nodes, [&](LocalIndex node) {
    const GlobalIndex gid = nth(scene.step.gid, node);
    return accepted_penetration(scene.settings.accepted, gid, body) > 0;
  });
}

/// The penetration of the edges at the start, along the present normal relative to them, where the scene accepts it
/// [length].
double accepted_overlap(const EdgeScene& scene, const EdgePair& pair, const EdgeMeeting& met) {
  const std::span<const Vec3> reference = scene.input.reference;
  if (reference.empty()) return 0;
  const auto& [slave, master, size] = pair;
  if (!has_accepted_end(scene, slave, master.body) && !has_accepted_end(scene, master, slave.body)) return 0;
  const auto at_start = [&](const ContactEdge& edge) {
    return geometry::Segment{nth(reference, edge.nodes[0]), nth(reference, edge.nodes[1])};
  };
  const geometry::Segment own = at_start(slave), other = at_start(master);
  const Mat3 turned = axes_of(own, other) * axes_of(scene.start(slave), scene.start(master)).transpose();
  const auto start = geometry::crossing_along(own, other, turned * met.normal, scene.tolerances().kink);
  return start ? std::max(0.0, -start->gap) : 0.0;
}

Row row_of(const EdgeScene& scene, const EdgePair& pair, const EdgeMeeting& met) {
  const auto& [slave, master, size] = pair;
  const auto id = [&](LocalIndex node) { return nth(scene.step.gid, node); };
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

bool has_flat_edge(const EdgePair& pair) {
  return pair.slave.flat || pair.master.flat;
}

/// Whether mortar rows with the other body hold both ends of one of the edges.
bool are_held(const EdgeInput& input, const EdgePair& pair) {
  if (input.held.empty()) return false;
  const auto holds = [&](const ContactEdge& edge, std::int32_t body) {
    return std::ranges::all_of(edge.nodes, [&](LocalIndex node) { return nth(input.held, node).has(body); });
  };
  return holds(pair.slave, pair.master.body) || holds(pair.master, pair.slave.body);
}

/// Passes 1 to 5 for two sharp edges. near: candidates of the slave edge.
std::optional<EdgeMeeting> meet_sharp(const EdgeScene& scene, const EdgePair& pair, std::span<const LocalIndex> near) {
  auto met = meet_now(scene, pair);
  if (!met && !is_slow(scene, pair)) met = meet_in_step(scene, pair);
  if (!met || is_on_ledge(scene, pair, *met, near) || is_held_at_ends(scene, pair, *met)) return std::nullopt;
  if (const auto normal = face_below(scene, pair); normal) {
    const auto along = geometry::crossing_along(scene.start(pair.slave), scene.start(pair.master), *normal);
    if (!along) return std::nullopt;
    met = EdgeMeeting{along->s, along->t, along->gap, along->normal};
  }
  return met;
}

/// Passes 1 to 5: where and along which normal the edges have a row, if any.
std::optional<EdgeMeeting> meet(const EdgeScene& scene, const EdgePair& pair, std::span<const LocalIndex> near) {
  std::optional<EdgeMeeting> met;
  if (!has_flat_edge(pair)) {
    met = meet_sharp(scene, pair, near);
  } else {
    met = cross_rim(scene, pair);
    if (met && is_on_ledge(scene, pair, *met, near)) return std::nullopt;
  }
  if (met && meet_at_lateral_face_of_seam(scene, pair, *met)) return std::nullopt;
  return met;
}

}  // namespace

void detect_edges(const StepView& step, const EdgeInput& input, std::vector<Row>& rows) {
  const EdgeScene scene(step, input);
  for (std::size_t e = 0; e < input.candidates.slaves.size(); ++e) {
    const ContactEdge& slave = input.candidates.slaves[e];
    const geometry::Box slave_box = scene.sweep(slave);
    const std::span<const LocalIndex> near = input.candidates.near.row(static_cast<LocalIndex>(e));
    for (const LocalIndex m : near) {
      const ContactEdge& master = scene.master(m);
      if (!geometry::overlaps(scene.reach(master), slave_box)) continue;
      const EdgePair pair{slave, master, std::min(scene.length(slave), scene.length(master))};
      if (are_held(input, pair)) continue;
      auto met = meet(scene, pair, near);
      if (!met) continue;
      met->gap += accepted_overlap(scene, pair, *met);
      Row& row = rows.emplace_back(row_of(scene, pair, *met));
      const double overhang = has_flat_edge(pair) ? scene.tolerances().ledge * pair.size : 0;
      row.required = required_rate(row, row.gap + overhang, pair.size, step);
    }
  }
}

}  // namespace brunt::contact
