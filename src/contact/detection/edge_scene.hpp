// SPDX-License-Identifier: Apache-2.0
// The edges of a step: what the files that detect contact of edges share.
#pragma once
#include <array>
#include <span>

#include "contact/data/tolerances.hpp"
#include "contact/detection/edges.hpp"
#include "geometry/box.hpp"
#include "geometry/segments.hpp"

namespace brunt::contact {

/// A slave edge and a master edge.
struct EdgePair {
  const ContactEdge& slave;
  const ContactEdge& master;
  double size = 0;  ///< length of the shorter one [length]
};

/// The crossing of two edges: points (1-s) a0 + s a1 of the slave and (1-t) b0 + t b1 of the master.
struct EdgeMeeting {
  double s = 0, t = 0;
  double gap = 0;              ///< [length]
  Vec3 normal = Vec3::Zero();  ///< unit, out of the master
};

/// All edges of a step.
struct EdgeScene {
  StepView step;
  EdgeInput input;
  const DetectionSettings& settings;
  double sine_of_one_direction;  ///< of the angle Tolerances::same_direction

  EdgeScene(const StepView& of_step, const EdgeInput& of_input);

  [[nodiscard]] const Tolerances& tolerances() const { return *settings.tolerances; }
  [[nodiscard]] const NodeMotion& at(LocalIndex node) const { return nth(step.motion, node); }
  [[nodiscard]] const NodeHold& hold(LocalIndex node) const { return nth(input.holds, node); }
  [[nodiscard]] const ContactEdge& master(LocalIndex index) const { return nth(input.candidates.masters, index); }
  [[nodiscard]] geometry::Segment start(const ContactEdge& edge) const {
    return {at(edge.nodes[0]).position, at(edge.nodes[1]).position};
  }
  [[nodiscard]] geometry::Segment end(const ContactEdge& edge) const {
    const geometry::Segment from = start(edge);
    return {from.start + step.dt * at(edge.nodes[0]).predicted, from.end + step.dt * at(edge.nodes[1]).predicted};
  }
  /// Unit normal of one of the two faces that share the edge.
  [[nodiscard]] Vec3 normal(const ContactEdge& edge, std::size_t facet) const {
    return nth(input.facet_normal, edge.facets[facet]);
  }
  /// Sum of the normals of both faces.
  [[nodiscard]] Vec3 outward(const ContactEdge& edge) const { return normal(edge, 0) + normal(edge, 1); }
  [[nodiscard]] double length(const ContactEdge& edge) const {
    const geometry::Segment at_start = start(edge);
    return (at_start.end - at_start.start).norm();
  }
  [[nodiscard]] geometry::Box sweep(const ContactEdge& edge) const {
    const geometry::Segment from = start(edge), to = end(edge);
    return geometry::bounding_box(std::array{from.start, from.end, to.start, to.end});
  }
  /// Box outside of which nothing meets this master in the step, whether it is a candidate or not.
  [[nodiscard]] geometry::Box reach(const ContactEdge& master) const {
    return geometry::grown(sweep(master), tolerances().reach(length(master), master.element_depth));
  }
};

/// Sine of the angle between the edges.
double sine_between(const EdgeScene& scene, const EdgePair& pair);

/// Whether the angle between the edges is less than Tolerances::same_direction.
bool are_nearly_parallel(const EdgeScene& scene, const EdgePair& pair);

/// Whether `direction` lies in the normal cone of the edge: between the normals of its two faces, or beyond them by at
/// most an angle with the sine `beyond`. False for an edge that has become flat.
bool between_normals(const EdgeScene& scene, const ContactEdge& edge, const Vec3& direction, double beyond);

/// Displacement of the slave's point s relative to the master's point t over a step; which: old_velocity for the last
/// one, predicted for this one.
template <Vec3 NodeMotion::*which>
Vec3 relative_displacement(const EdgeScene& scene, const EdgePair& pair, double s, double t) {
  const auto velocity = [&](const ContactEdge& edge, std::size_t i) { return scene.at(edge.nodes[i]).*which; };
  return scene.step.dt * ((1 - s) * velocity(pair.slave, 0) + s * velocity(pair.slave, 1) -
                          (1 - t) * velocity(pair.master, 0) - t * velocity(pair.master, 1));
}

/// Whether the edges move so little relative to each other that their positions at the start of a step suffice.
bool is_slow(const EdgeScene& scene, const EdgePair& pair);

/// The largest penetration at which the edges are in contact [length].
double max_penetration(const EdgeScene& scene, const EdgePair& pair);

}  // namespace brunt::contact
