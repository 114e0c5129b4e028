// SPDX-License-Identifier: Apache-2.0
#include "edge_ledges.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "contact/data/tolerances.hpp"
#include "contact/detection/ledges.hpp"

namespace brunt::contact {
namespace {

/// An edge that may slide over a ledge: the meeting, and the relative displacement there in the last step. (The
/// predicted one includes the load, see last_displacement in ledges.cpp.)
struct Slide {
  const EdgeScene& scene;
  const EdgePair& pair;
  const EdgeMeeting& met;
  Vec3 motion;  ///< [length]

  [[nodiscard]] const Tolerances& tolerances() const { return scene.tolerances(); }
  [[nodiscard]] bool into(const Vec3& normal, const Vec3& along) const {
    return slides_into(motion, normal, along, pair.size, tolerances());
  }
};

/// Whether both ends of an edge have rows along `out`, with any bodies: the front of a block that passes the seam of
/// two plates lies on both.
bool lies_along(const EdgeScene& scene, const ContactEdge& edge, const Vec3& out) {
  return std::ranges::all_of(
      edge.nodes, [&](LocalIndex node) { return scene.hold(node).normal.dot(out) > scene.tolerances().aligned; });
}

/// Nearly parallel edges that slide past each other on a ledge: along a face of the master, no farther from its plane
/// than a ledge. If the edges cross, one must lie on a face of the other with both ends constrained along its normal.
/// Otherwise they constrain each other, however small their angle, since contact would supply energy without these
/// rows.
bool slide_along_ledge(const Slide& slide) {
  const auto& [scene, pair, met, motion] = slide;
  const auto& [slave, master, size] = pair;
  const double sine = sine_between(scene, pair);
  if (sine >= scene.sine_of_one_direction) return false;
  const geometry::Segment own = scene.start(slave), other = scene.start(master);
  const Vec3 apart = (1 - met.s) * own.start + met.s * own.end - (1 - met.t) * other.start - met.t * other.end;
  const auto opposes = [&](std::size_t i, const Vec3& normal) {
    return scene.normal(slave, i).dot(normal) < -scene.tolerances().facing;
  };
  // face i of the slave lies on face k of the master, and the other two are the lateral faces
  const auto lies_on = [&](std::size_t i, std::size_t k) {
    const Vec3 top = scene.normal(master, k), lateral = scene.normal(master, 1 - k);
    const double height = apart.dot(top);
    if (sine > scene.tolerances().parallel && !lies_along(scene, slave, top) && !lies_along(scene, master, -top))
      return false;
    return opposes(i, top) && opposes(1 - i, lateral) && std::abs(height) <= scene.tolerances().ledge * size &&
           slide.into(lateral, top) &&
           std::abs(motion.dot(top)) < scene.tolerances().slight * std::abs(motion.dot(lateral));
  };
  return lies_on(0, 0) || lies_on(0, 1) || lies_on(1, 0) || lies_on(1, 1);
}

/// Whether the predicate is true of an end of the edge within a ledge of the crossing. at: parameter of the crossing on
/// the edge, 0 at the first end.
template <class Predicate>
bool any_end_at_ledge(const Slide& slide, const ContactEdge& edge, double at, Predicate&& predicate) {
  const double reach = slide.tolerances().ledge * slide.pair.size / slide.scene.length(edge);
  return (at <= reach && predicate(std::size_t{0})) || (1 - at <= reach && predicate(std::size_t{1}));
}

/// Whether the slave edge stands upright on one of its ends, which slides over a ledge.
bool stands_at_ledge(const Slide& slide) {
  const ContactEdge& slave = slide.pair.slave;
  return any_end_at_ledge(slide, slave, slide.met.s, [&](std::size_t end) {
    const Vec3& normal = slide.scene.hold(slave.nodes[end]).normal;
    return std::abs(normal.dot(slide.scene.start(slave).along())) > slide.tolerances().aligned &&
           slide.into(slide.met.normal, normal);
  });
}

/// The same for the master edge. The rows of its nodes are not known. Instead, a face of the slave edge must lie across
/// the master edge, and no other edge within reach may continue it beyond its end. Corners that meet form no ledge.
bool is_stood_at_ledge(const Slide& slide, std::span<const LocalIndex> near) {
  const EdgeScene& scene = slide.scene;
  const ContactEdge &slave = slide.pair.slave, &master = slide.pair.master;
  if (any_end_at_ledge(slide, slave, slide.met.s, [](std::size_t) { return true; })) return false;
  const Vec3 along = scene.start(master).along();
  const geometry::Box slave_box = scene.sweep(slave);
  return any_end_at_ledge(slide, master, slide.met.t, [&](std::size_t end) {
    const auto continues = [&](LocalIndex m) {
      const ContactEdge& other = scene.master(m);
      return other.nodes != master.nodes && std::ranges::find(other.nodes, master.nodes[end]) != other.nodes.end() &&
             geometry::overlaps(scene.reach(other), slave_box) &&
             std::abs(scene.start(other).along().dot(along)) > scene.tolerances().aligned;
    };
    const auto lies_across = [&](std::size_t facet) {
      const Vec3 normal = scene.normal(slave, facet);
      return std::abs(normal.dot(along)) > scene.tolerances().aligned && slide.into(slide.met.normal, -normal);
    };
    return (lies_across(0) || lies_across(1)) && std::ranges::none_of(near, continues);
  });
}

}  // namespace

bool is_on_ledge(const EdgeScene& scene, const EdgePair& pair, const EdgeMeeting& met,
                 std::span<const LocalIndex> near) {
  const Slide slide{scene, pair, met, relative_displacement<&NodeMotion::old_velocity>(scene, pair, met.s, met.t)};
  return slide_along_ledge(slide) || stands_at_ledge(slide) || is_stood_at_ledge(slide, near);
}

std::optional<Vec3> face_below(const EdgeScene& scene, const EdgePair& pair) {
  if (!are_nearly_parallel(scene, pair)) return std::nullopt;
  for (std::size_t k = 0; k < 2; ++k) {
    if (const Vec3 top = scene.normal(pair.master, k); lies_along(scene, pair.slave, top)) return top;
    if (const Vec3 top = -scene.normal(pair.slave, k); lies_along(scene, pair.master, -top)) return top;
  }
  return std::nullopt;
}

}  // namespace brunt::contact
