// SPDX-License-Identifier: Apache-2.0
// Edges where they are, for the files that detect their contact.
#pragma once
#include <array>
#include <span>

#include "contact/data/tolerances.hpp"
#include "contact/detection/edges.hpp"
#include "geometry/box.hpp"
#include "geometry/segments.hpp"

namespace brunt::contact {

/// How two edges meet: points (1-s) a0 + s a1 and (1-t) b0 + t b1.
struct EdgeMeeting {
  double s = 0, t = 0, gap = 0;
  Vec3 normal = Vec3::Zero();  ///< out of the master
};

/// The nodes and faces that detection of edges looks at.
struct EdgeScene {
  std::span<const GlobalIndex> gid;
  std::span<const NodeMotion> motion;
  std::span<const Vec3> facet_normal, reference;
  double dt;
  const DetectionSettings& settings;
  double full;  ///< sine of the angle Tolerances::same_direction

  [[nodiscard]] const Tolerances& tolerances() const { return *settings.tolerances; }
  [[nodiscard]] const NodeMotion& at(LocalIndex node) const { return motion[static_cast<std::size_t>(node)]; }
  [[nodiscard]] geometry::Segment start(const ContactEdge& edge) const {
    return {at(edge.nodes[0]).position, at(edge.nodes[1]).position};
  }
  [[nodiscard]] geometry::Segment end(const ContactEdge& edge) const {
    const geometry::Segment from = start(edge);
    return {from.start + dt * at(edge.nodes[0]).predicted, from.end + dt * at(edge.nodes[1]).predicted};
  }
  [[nodiscard]] Vec3 normal(const ContactEdge& edge, std::size_t side) const {
    return facet_normal[static_cast<std::size_t>(edge.facets[side])];
  }
  [[nodiscard]] Vec3 outward(const ContactEdge& edge) const { return normal(edge, 0) + normal(edge, 1); }
  [[nodiscard]] double length(const ContactEdge& edge) const {
    const geometry::Segment at_start = start(edge);
    return (at_start.end - at_start.start).norm();
  }
  [[nodiscard]] geometry::Box sweep(const ContactEdge& edge) const {
    const geometry::Segment from = start(edge), to = end(edge);
    return geometry::bounding_box(std::array{from.start, from.end, to.start, to.end});
  }
  /// What is outside of it has nothing to do with this master in this step, whether the lists name it or not.
  [[nodiscard]] geometry::Box reach(const ContactEdge& master) const {
    return geometry::grown(sweep(master), tolerances().reach(length(master), master.element_depth));
  }
};

/// Does `direction` lie between the normals of the two faces of a convex edge, or beyond them by no more than rounding
/// and the curvature of a facet? beyond: sine of the angle.
bool between_normals(const EdgeScene& scene, const ContactEdge& edge, const Vec3& direction, double beyond);

/// How far the points (s, t) move apart within the step.
Vec3 relative_displacement(const EdgeScene& scene, const ContactEdge& slave, const ContactEdge& master, double s,
                           double t);

/// Edges that move little against each other are seen in time at the start of a step.
bool is_slow(const EdgeScene& scene, const ContactEdge& slave, const ContactEdge& master, double size);

}  // namespace brunt::contact
