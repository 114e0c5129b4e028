// SPDX-License-Identifier: Apache-2.0
#include "edge_ledges.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "contact/data/tolerances.hpp"
#include "contact/detection/ledges.hpp"

namespace brunt::contact {
namespace {

/// How the edges have moved against each other in the last step, where they meet: see last_displacement in ledges.cpp.
Vec3 last_displacement(const EdgeScene& scene, const ContactEdge& slave, const ContactEdge& master,
                       const EdgeMeeting& met) {
  const auto last = [&](const ContactEdge& edge, std::size_t i) { return scene.at(edge.nodes[i]).old_velocity; };
  return scene.dt * ((1 - met.s) * last(slave, 0) + met.s * last(slave, 1) - (1 - met.t) * last(master, 0) -
                     met.t * last(master, 1));
}

/// Whether both ends of an edge are held along `out`, by whatever bodies: the front of a block that passes the seam of
/// two plates lies on both.
bool lies_along(const EdgeScene& scene, std::span<const NodeHold> holds, const ContactEdge& edge, const Vec3& out) {
  return std::ranges::all_of(edge.nodes, [&](LocalIndex node) {
    return holds[static_cast<std::size_t>(node)].normal.dot(out) > scene.tolerances().aligned;
  });
}

/// Nearly parallel edges that slide past each other on a ledge (see ledges.hpp): along a face of the master, no farther
/// from its plane than a ledge. If the edges cross, one must lie on a face of the other with both ends constrained
/// along its normal. Otherwise they constrain each other, however small their angle, since contact would supply energy
/// without these rows.
bool slide_along_ledge(const EdgeScene& scene, std::span<const NodeHold> holds, const ContactEdge& slave,
                       const ContactEdge& master, double size, const EdgeMeeting& met, const Vec3& motion) {
  const geometry::Segment own = scene.start(slave), other = scene.start(master);
  const double sine = own.along().cross(other.along()).norm();
  if (sine >= scene.full) return false;
  const Vec3 apart = (1 - met.s) * own.start + met.s * own.end - (1 - met.t) * other.start - met.t * other.end;
  const auto faces = [&](const ContactEdge& edge, std::size_t i, const Vec3& normal) {
    return scene.normal(edge, i).dot(normal) < -scene.tolerances().facing;
  };
  // face i of the slave lies on face k of the master, and the others meet
  const auto lies_on = [&](std::size_t i, std::size_t k) {
    const Vec3 top = scene.normal(master, k), side = scene.normal(master, 1 - k);
    const double height = apart.dot(top);
    if (sine > scene.tolerances().parallel && !lies_along(scene, holds, slave, top) &&
        !lies_along(scene, holds, master, -top))
      return false;
    return faces(slave, i, top) && faces(slave, 1 - i, side) && std::abs(height) <= scene.tolerances().ledge * size &&
           slides_into(motion, side, top, size, scene.tolerances()) &&
           std::abs(motion.dot(top)) < scene.tolerances().slight * std::abs(motion.dot(side));
  };
  return lies_on(0, 0) || lies_on(0, 1) || lies_on(1, 0) || lies_on(1, 1);
}

/// Calls visit(end) for the ends of the edge that are within a ledge of where it is met; at: that, from its first end.
template <class Visit>
bool any_end_at_ledge(const EdgeScene& scene, const ContactEdge& edge, double at, double size, Visit&& visit) {
  const double reach = scene.tolerances().ledge * size / scene.length(edge);
  return (at <= reach && visit(std::size_t{0})) || (1 - at <= reach && visit(std::size_t{1}));
}

/// Does the slave edge stand on one of its ends, and come with it to a ledge?
bool stands_at_ledge(const EdgeScene& scene, std::span<const NodeHold> holds, const ContactEdge& slave, double size,
                     const EdgeMeeting& met, const Vec3& motion) {
  return any_end_at_ledge(scene, slave, met.s, size, [&](std::size_t end) {
    const Vec3& normal = holds[static_cast<std::size_t>(slave.nodes[end])].normal;
    return std::abs(normal.dot(scene.start(slave).along())) > scene.tolerances().aligned &&
           slides_into(motion, met.normal, normal, size, scene.tolerances());
  });
}

/// Is it the other way round? What holds the end of a master edge is not known, but that the slave edge has a face
/// across it, and that no other edge within reach goes on from there. Corner on corner is no ledge.
bool meets_ledge_below(const EdgeScene& scene, const EdgeCandidates& candidates, std::span<const LocalIndex> near,
                       const ContactEdge& slave, const ContactEdge& master, double size, const EdgeMeeting& met,
                       const Vec3& motion) {
  if (any_end_at_ledge(scene, slave, met.s, size, [](std::size_t) { return true; })) return false;
  const Vec3 along = scene.start(master).along();
  const geometry::Box slave_box = scene.sweep(slave);
  return any_end_at_ledge(scene, master, met.t, size, [&](std::size_t end) {
    const auto continues = [&](LocalIndex m) {
      const ContactEdge& other = candidates.masters[static_cast<std::size_t>(m)];
      return other.nodes != master.nodes && std::ranges::find(other.nodes, master.nodes[end]) != other.nodes.end() &&
             geometry::overlaps(scene.reach(other), slave_box) &&
             std::abs(scene.start(other).along().dot(along)) > scene.tolerances().aligned;
    };
    const auto crosses = [&](std::size_t side) {
      const Vec3 normal = scene.normal(slave, side);
      return std::abs(normal.dot(along)) > scene.tolerances().aligned &&
             slides_into(motion, met.normal, -normal, size, scene.tolerances());
    };
    return (crosses(0) || crosses(1)) && std::ranges::none_of(near, continues);
  });
}

}  // namespace

bool meet_on_ledge(const EdgeScene& scene, const EdgeCandidates& candidates, std::span<const LocalIndex> near,
                   std::span<const NodeHold> holds, const ContactEdge& slave, const ContactEdge& master,
                   const EdgeMeeting& met) {
  const double size = std::min(scene.length(slave), scene.length(master));
  const Vec3 slid = last_displacement(scene, slave, master, met);
  return slide_along_ledge(scene, holds, slave, master, size, met, slid) ||
         stands_at_ledge(scene, holds, slave, size, met, slid) ||
         meets_ledge_below(scene, candidates, near, slave, master, size, met, slid);
}

std::optional<Vec3> face_below(const EdgeScene& scene, std::span<const NodeHold> holds, const ContactEdge& slave,
                               const ContactEdge& master) {
  if (scene.start(slave).along().cross(scene.start(master).along()).norm() >= scene.full) return std::nullopt;
  for (std::size_t k = 0; k < 2; ++k) {
    if (const Vec3 top = scene.normal(master, k); lies_along(scene, holds, slave, top)) return top;
    if (const Vec3 top = -scene.normal(slave, k); lies_along(scene, holds, master, -top)) return top;
  }
  return std::nullopt;
}

}  // namespace brunt::contact
