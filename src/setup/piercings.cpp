// SPDX-License-Identifier: Apache-2.0
#include "setup/piercings.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>

#include "contact/data/tolerances.hpp"
#include "contact/search/box_overlaps.hpp"
#include "geometry/segment_face.hpp"

namespace brunt::setup {
namespace {

using geometry::Box;

struct Crossing {
  double along;
  bool inward;
  std::size_t face;
};

/// Corners of the face's edge or vertex given by the region; both equal at a vertex, none inside the face.
std::array<std::size_t, 2> corners_of(geometry::Region region, std::size_t corner_count) {
  using geometry::Region;
  if (region >= Region::vertex0) {
    const auto vertex = static_cast<std::size_t>(region) - static_cast<std::size_t>(Region::vertex0);
    return {vertex, vertex};
  }
  const auto edge = static_cast<std::size_t>(region) - static_cast<std::size_t>(Region::edge0);
  return {edge, (edge + 1) % corner_count};
}

/// Angle between the two edges of the face at a corner [rad].
double angle_at(const SolidFace& face, std::size_t corner) {
  const Vec3 one = face.corners[(corner + 1) % face.corner_count] - face.corners[corner];
  const Vec3 other = face.corners[(corner + face.corner_count - 1) % face.corner_count] - face.corners[corner];
  return std::atan2(one.cross(other).norm(), one.dot(other));
}

struct NearestPlace {
  LocalIndex face = no_index;
  geometry::FacePoint point;
  double distance = std::numeric_limits<double>::infinity();
};

/// Pseudo-normal at the nearest point, whose sign distinguishes inside from outside: the normal, at an edge the sum of
/// the normals of its faces, at a vertex that sum weighted by the faces' angles (Baerentzen and Aanaes 2005). The
/// normal of one face is not sufficient: a point near a sharp edge may be behind one of its faces and in front of the
/// other, although it is outside.
Vec3 outward_at(const Solid& solid, const std::vector<LocalIndex>& near, const NearestPlace& nearest) {
  const SolidFace& of_nearest = nth(solid.faces, nearest.face);
  if (nearest.point.region == geometry::Region::face)
    return geometry::face_normal(of_nearest.points(), nearest.point.xi, nearest.point.eta);
  const auto [first, second] = corners_of(nearest.point.region, of_nearest.corner_count);
  Vec3 sum = Vec3::Zero();
  for (const LocalIndex f : near) {
    const SolidFace& face = nth(solid.faces, f);
    const auto end = face.nodes.begin() + static_cast<std::ptrdiff_t>(face.corner_count);
    const auto here = std::find(face.nodes.begin(), end, of_nearest.nodes[first]);
    if (here == end || std::find(face.nodes.begin(), end, of_nearest.nodes[second]) == end) continue;
    const auto place = geometry::closest_point(nearest.point.point, face.points());
    if (!place) continue;
    const auto corner = static_cast<std::size_t>(here - face.nodes.begin());
    sum +=
        (first == second ? angle_at(face, corner) : 1.0) * geometry::face_normal(face.points(), place->xi, place->eta);
  }
  return sum.normalized();
}

/// Whether the middle of the stretch that begins or ends at the crossing is deeper inside than `touching`. A false
/// crossing due to rounding, where the segment only touches, has a stretch outside.
bool is_deep(const Solid& solid, const std::vector<LocalIndex>& near, const Vec3& middle,
             const contact::Tolerances& tolerances) {
  NearestPlace nearest;
  for (const LocalIndex f : near) {
    const SolidFace& face = nth(solid.faces, f);
    const auto closest = geometry::closest_point(middle, face.points());
    if (!closest) continue;
    const double distance = (middle - closest->point).norm();
    if (distance <= tolerances.touching * face.size) return false;
    if (distance < nearest.distance) nearest = {f, *closest, distance};
  }
  if (nearest.face == no_index) return true;  // no face decides
  return (middle - nearest.point.point).dot(outward_at(solid, near, nearest)) < -tolerances.rounding * nearest.distance;
}

/// The face through which the segment enters a stretch deep inside.
std::optional<std::size_t> pierced_face(const Solid& solid, const std::vector<LocalIndex>& near,
                                        const geometry::Segment& segment, const contact::Tolerances& tolerances) {
  std::vector<Crossing> crossings;
  for (const LocalIndex f : near) {
    const auto met = geometry::segment_crosses_face(segment, nth(solid.faces, f).points());
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
    if (to > from && is_deep(solid, near, segment.start + middle * (segment.end - segment.start), tolerances))
      return here.face;
  }
  return std::nullopt;
}

}  // namespace

std::vector<PiercingEdge> piercing_edges(const mesh::Mesh& mesh, const Solid& one, const Solid& other,
                                         const std::vector<char>& inside, const contact::Tolerances& tolerances) {
  std::vector<PiercingEdge> result;
  if (!geometry::overlaps(one.box, other.box)) return result;
  const auto at = [&](LocalIndex node) -> const Vec3& { return nth(mesh.coordinates, node); };
  const auto is_inside = [&](LocalIndex node) { return node != no_index && nth(inside, node) != 0; };
  std::vector<std::array<LocalIndex, 2>> edges;
  std::vector<Box> edge_boxes, face_boxes;
  for (const auto& edge : one.edges) {
    if (is_inside(edge[0]) || is_inside(edge[1])) continue;
    const Box box = geometry::bounding_box(std::array{at(edge[0]), at(edge[1])});
    if (!geometry::overlaps(box, other.box)) continue;
    edges.push_back(edge);
    // The middle of a stretch is at most half the edge from the crossing: the face nearest to it is in this box.
    edge_boxes.push_back(geometry::grown(box, 0.5 * (at(edge[1]) - at(edge[0])).norm()));
  }
  for (const SolidFace& face : other.faces)
    face_boxes.push_back(geometry::grown(geometry::bounding_box(face.points()), tolerances.touching * face.size));
  std::map<LocalIndex, std::vector<LocalIndex>> near;  // faces by edge, in a fixed order
  contact::OverlapScratch scratch;
  contact::for_each_overlap(edge_boxes, face_boxes, scratch, [&](LocalIndex e, LocalIndex f) { near[e].push_back(f); });
  for (auto& [e, faces] : near) {
    std::ranges::sort(faces);
    const auto edge = nth(edges, e);
    const auto pierced = pierced_face(other, faces, {at(edge[0]), at(edge[1])}, tolerances);
    if (pierced && std::ranges::none_of(other.faces[*pierced].nodes, is_inside)) result.push_back({edge, *pierced});
  }
  return result;
}

}  // namespace brunt::setup
