// SPDX-License-Identifier: Apache-2.0
#include "piercings.hpp"

#include <algorithm>
#include <limits>
#include <map>
#include <optional>

#include "brunt/contact/search/box_overlaps.hpp"
#include "brunt/geometry/segment_face.hpp"

namespace brunt::app {
namespace {

using geometry::Box;

struct Crossing {
  double along;
  bool inward;
  std::size_t face;
};

/// Deeper inside than `touching`, in the middle of the stretch that begins or ends at the crossing? Behind the nearest
/// face, that is: a crossing that rounding has made where the segment only touches has a stretch outside.
bool is_deep(const Solid& solid, const std::vector<LocalIndex>& near, const Vec3& middle) {
  constexpr double as_near = 1e-9, along_face = 1e-6;  // faces that meet where it is nearest; sine of an angle
  double nearest = std::numeric_limits<double>::infinity();
  bool behind = true;  // where no face can tell
  for (const LocalIndex f : near) {
    const SolidFace& face = solid.faces[static_cast<std::size_t>(f)];
    const auto closest = geometry::closest_point(middle, face.points());
    if (!closest) continue;
    const Vec3 offset = middle - closest->point;
    const double distance = offset.norm();
    if (distance <= touching * face.size) return false;
    if (distance > (1 + as_near) * nearest) continue;
    const bool behind_this =
        offset.dot(geometry::face_normal(face.points(), closest->xi, closest->eta)) < -along_face * distance;
    behind = behind_this || (behind && distance >= (1 - as_near) * nearest);
    nearest = std::min(nearest, distance);
  }
  return behind;
}

/// The face through which the segment comes to a stretch deep inside.
std::optional<std::size_t> pierced_face(const Solid& solid, const std::vector<LocalIndex>& near,
                                        const geometry::Segment& segment) {
  std::vector<Crossing> crossings;
  for (const LocalIndex f : near) {
    const auto met = geometry::segment_crosses_face(segment, solid.faces[static_cast<std::size_t>(f)].points());
    if (met) crossings.push_back({met->along, met->inward, static_cast<std::size_t>(f)});
  }
  std::ranges::sort(crossings, {}, &Crossing::along);
  for (std::size_t k = 0; k < crossings.size(); ++k) {
    const Crossing& here = crossings[k];
    double from = here.along, to = here.along;
    if (here.inward)
      to = k + 1 < crossings.size() ? crossings[k + 1].along : 1.0;
    else
      from = k > 0 ? crossings[k - 1].along : 0.0;
    const double middle = 0.5 * (from + to);
    if (to > from && is_deep(solid, near, segment.start + middle * (segment.end - segment.start))) return here.face;
  }
  return std::nullopt;
}

}  // namespace

std::vector<PiercingEdge> piercing_edges(const mesh::Mesh& mesh, const Solid& one, const Solid& other,
                                         const std::vector<char>& inside) {
  std::vector<PiercingEdge> result;
  if (!geometry::overlaps(one.box, other.box)) return result;
  const auto at = [&](LocalIndex node) -> const Vec3& { return mesh.coordinates[static_cast<std::size_t>(node)]; };
  const auto is_inside = [&](LocalIndex node) {
    return node != no_index && inside[static_cast<std::size_t>(node)] != 0;
  };
  std::vector<std::array<LocalIndex, 2>> edges;
  std::vector<Box> edge_boxes, face_boxes;
  for (const auto& edge : one.edges) {
    if (is_inside(edge[0]) || is_inside(edge[1])) continue;
    const Box box = geometry::bounding_box(std::array{at(edge[0]), at(edge[1])});
    if (!geometry::overlaps(box, other.box)) continue;
    edges.push_back(edge);
    edge_boxes.push_back(box);
  }
  for (const SolidFace& face : other.faces)
    face_boxes.push_back(geometry::grown(geometry::bounding_box(face.points()), touching * face.size));
  std::map<LocalIndex, std::vector<LocalIndex>> near;  // faces by edge, in a fixed order
  contact::OverlapScratch scratch;
  contact::for_each_overlap(edge_boxes, face_boxes, scratch, [&](LocalIndex e, LocalIndex f) { near[e].push_back(f); });
  for (auto& [e, faces] : near) {
    std::ranges::sort(faces);
    const auto edge = edges[static_cast<std::size_t>(e)];
    const auto pierced = pierced_face(other, faces, {at(edge[0]), at(edge[1])});
    if (pierced && std::ranges::none_of(other.faces[*pierced].nodes, is_inside)) result.push_back({edge, *pierced});
  }
  return result;
}

}  // namespace brunt::app
