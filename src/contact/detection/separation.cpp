// SPDX-License-Identifier: Apache-2.0
#include "contact/detection/separation.hpp"

#include <algorithm>
#include <array>
#include <limits>

#include "contact/data/tolerances.hpp"
#include "edge_scene.hpp"

namespace brunt::contact {
namespace {

using geometry::Box;

constexpr double nowhere = std::numeric_limits<double>::infinity();

/// Distance along the axis of largest separation; negative for overlapping boxes. It decreases by the motion of both
/// boxes, and by the growth of the reach, which is at most half of the motion of the nodes.
double apart(const Box& one, const Box& other) {
  return std::max((one.low - other.high).maxCoeff(), (other.low - one.high).maxCoeff());
}

}  // namespace

double separation_of_faces(const StepView& step, const Candidates& candidates, std::span<const FaceReach> reach) {
  double least = nowhere;
  for (std::size_t s = 0; s < candidates.slave.size(); ++s) {
    const NodeMotion& node = nth(step.motion, candidates.slave[s]);
    const Box sweep = geometry::bounding_box(std::array{node.position, Vec3(node.position + step.dt * node.predicted)});
    const double clearance = candidates.half_thickness.empty() ? 0.0 : candidates.half_thickness[s];
    for (const LocalIndex face : candidates.faces.row(static_cast<LocalIndex>(s)))
      least = std::min(least, apart(nth(reach, face).box, sweep) - clearance);
  }
  return least;
}

double separation_of_edges(const StepView& step, const EdgeCandidates& candidates) {
  const EdgeScene scene(step, {.candidates = candidates});
  double least = nowhere;
  for (std::size_t e = 0; e < candidates.slaves.size(); ++e) {
    const Box sweep = scene.sweep(candidates.slaves[e]);
    for (const LocalIndex master : candidates.near.row(static_cast<LocalIndex>(e)))
      least = std::min(least, apart(scene.reach(nth(candidates.masters, master)), sweep));
  }
  return least;
}

double separation_of_walls(const StepView& step, std::span<const WallCandidate> candidates,
                           std::span<const Wall> walls) {
  double least = nowhere;
  for (const WallCandidate& candidate : candidates) {
    const Wall& wall = nth(walls, candidate.wall);
    if (wall.bilateral && candidate.held) return 0;
    const NodeMotion& node = nth(step.motion, candidate.node);
    const double gap = (node.position - wall.point).dot(wall.normal);
    const double next = gap + step.dt * (node.predicted - wall.velocity).dot(wall.normal);
    least = std::min(least, std::min(gap, next) - step.settings.tolerances->capture * step.settings.wall_size);
  }
  return least;
}

}  // namespace brunt::contact
