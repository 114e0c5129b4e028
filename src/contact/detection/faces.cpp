// SPDX-License-Identifier: Apache-2.0
// Node against face: static closest point, choice among the faces of a body.
#include <algorithm>

#include "brunt/contact/detection/detection.hpp"
#include "brunt/geometry/closest_point.hpp"

namespace brunt::contact {
namespace {

using geometry::Box;

struct Scene {
  std::span<const MasterFace> faces;
  std::span<const NodeMotion> motion;
  std::span<const FaceReach> reach;
  double dt;
  const DetectionSettings& settings;

  [[nodiscard]] const NodeMotion& at(LocalIndex node) const { return motion[static_cast<std::size_t>(node)]; }
};

inline void extend_by_sweep(Box& box, const NodeMotion& node, double dt) {
  geometry::extend(box, node.position);
  geometry::extend(box, node.position + dt * node.predicted);
}

/// The positions of a face's corners.
geometry::Corners gather_corners(std::span<const NodeMotion> motion, const MasterFace& face,
                                 std::array<Vec3, 4>& storage) {
  const auto count = static_cast<std::size_t>(face.corner_count);
  for (std::size_t i = 0; i < count; ++i) storage[i] = motion[static_cast<std::size_t>(face.nodes[i])].position;
  return {storage.data(), count};
}

void measure_reach(std::span<const MasterFace> faces, std::span<const NodeMotion> motion, double dt, double capture,
                   std::vector<FaceReach>& reach) {
  reach.clear();
  std::array<Vec3, 4> storage;
  for (const MasterFace& face : faces) {
    Box sweep;
    for (std::size_t i = 0; i < static_cast<std::size_t>(face.corner_count); ++i)
      extend_by_sweep(sweep, motion[static_cast<std::size_t>(face.nodes[i])], dt);
    const double size = geometry::longest_edge(gather_corners(motion, face, storage));
    reach.push_back({geometry::grown(sweep, capture * size), size});
  }
}

double opposition(const Vec3& normal, std::span<const LocalIndex> facets, std::span<const Vec3> facet_normal) {
  double least = 1;
  for (const LocalIndex facet : facets)
    least = std::min(least, facet_normal[static_cast<std::size_t>(facet)].dot(normal));
  return -least;
}

Encounter encounter(const Scene& scene, const NodeMotion& slave, const Box& slave_sweep, LocalIndex face_index) {
  const FaceReach& face_reach = scene.reach[static_cast<std::size_t>(face_index)];
  Encounter result{.face = face_index, .size = face_reach.size};
  if (!geometry::overlaps(face_reach.box, slave_sweep)) return result;
  const MasterFace& face = scene.faces[static_cast<std::size_t>(face_index)];
  const double reach = scene.settings.capture * result.size;
  std::array<Vec3, 4> storage;
  const geometry::Corners corners = gather_corners(scene.motion, face, storage);
  const auto closest = geometry::closest_point(slave.position, corners);
  if (!closest) return result;

  result.weights = closest->weights;
  result.normal = geometry::face_normal(corners, closest->xi, closest->eta);
  const Vec3 offset = slave.position - closest->point;
  const double height = offset.dot(result.normal);
  const double beside = (offset - height * result.normal).norm();
  result.gap = height;
  if (height < -std::min(reach, scene.settings.element_share * face.depth)) return result;
  if (closest->region == geometry::Region::face) {
    result.meeting = Meeting::on_face;
  } else if (beside <= scene.settings.overhang * result.size) {
    result.meeting = Meeting::overhang;
  } else if (height > 0) {
    result.meeting = Meeting::edge;
    result.gap = offset.norm();
    result.normal = offset / result.gap;
  }
  return result;
}

/// Best of the encounters with the faces of one body, in ascending key; none where no face opposes the slave.
Encounter choose(std::span<const Encounter> encounters) {
  constexpr double sideways = 1e-6;  // what is left of surfaces at right angles after rounding opposes nothing
  double most_opposed = 0;
  for (const Encounter& e : encounters) most_opposed = std::max(most_opposed, e.opposition);
  Encounter best;
  if (most_opposed <= sideways) return best;
  for (const Encounter& e : encounters) {
    if (e.opposition < 0.5 * most_opposed) continue;
    const bool nearer = e.meeting == best.meeting && std::abs(e.gap) < std::abs(best.gap);
    if (e.meeting < best.meeting || nearer) best = e;
  }
  return best;
}

double required_rate(const Encounter& e, double dt, const DetectionSettings& settings) {
  if (e.gap >= 0) return -e.gap / dt;
  return std::min(-settings.recovery * e.gap, settings.recovery_limit * e.size) / dt;
}

Row row_of(const Encounter& e, const MasterFace& face, LocalIndex slave, double required) {
  Row row{.master_key = face.key, .master_body = face.body, .master_block = face.block};
  row.nodes[0] = slave;
  row.weights[0] = 1;
  row.node_count = 1;
  for (std::size_t i = 0; i < static_cast<std::size_t>(face.corner_count); ++i) {
    if (e.weights[i] == 0) continue;
    const auto k = static_cast<std::size_t>(row.node_count++);
    row.nodes[k] = face.nodes[i];
    row.weights[k] = -e.weights[i];
  }
  row.normal = e.normal;
  row.gap = e.gap;
  row.required = required;
  return row;
}

}  // namespace

void detect_faces(const Candidates& candidates, std::span<const MasterFace> faces, std::span<const GlobalIndex> gid,
                  std::span<const NodeMotion> motion, std::span<const Vec3> facet_area, double dt,
                  const DetectionSettings& settings, DetectionScratch& scratch, std::vector<Row>& rows) {
  measure_reach(faces, motion, dt, settings.capture, scratch.reach);
  scratch.facet_normal.clear();
  for (const Vec3& area : facet_area) scratch.facet_normal.push_back(area.normalized());
  const Scene scene{faces, motion, scratch.reach, dt, settings};
  for (std::size_t s = 0; s < candidates.slave.size(); ++s) {
    const LocalIndex slave = candidates.slave[s];
    const NodeMotion& node = scene.at(slave);
    Box slave_sweep;
    extend_by_sweep(slave_sweep, node, dt);
    const auto near = candidates.faces.row(static_cast<LocalIndex>(s));
    const auto facets = candidates.slave_facets.row(static_cast<LocalIndex>(s));
    const auto body_of = [&](std::size_t i) { return faces[static_cast<std::size_t>(near[i])].body; };

    for (std::size_t i = 0; i < near.size();) {
      const std::int32_t body = body_of(i);
      scratch.encounters.clear();
      for (; i < near.size() && body_of(i) == body; ++i) {
        const Encounter met = encounter(scene, node, slave_sweep, near[i]);
        if (met.meeting == Meeting::none) continue;
        scratch.encounters.push_back(met);
        scratch.encounters.back().opposition = opposition(met.normal, facets, scratch.facet_normal);
      }
      const Encounter best = choose(scratch.encounters);
      if (best.meeting == Meeting::none) continue;
      Row row = row_of(best, faces[static_cast<std::size_t>(best.face)], slave, required_rate(best, dt, settings));
      row.slave_gid = gid[static_cast<std::size_t>(slave)];
      row.slave_body = candidates.body[s];
      rows.push_back(row);
    }
  }
}

}  // namespace brunt::contact
