// SPDX-License-Identifier: Apache-2.0
// Node against face: the encounters of each slave, and the rows that come of them.
#include <algorithm>
#include <utility>

#include "brunt/contact/detection/detection.hpp"

namespace brunt::contact {
namespace {

using geometry::Box;

inline void extend_by_sweep(Box& box, const NodeMotion& node, double dt) {
  geometry::extend(box, node.position);
  geometry::extend(box, node.position + dt * node.predicted);
}

void measure_reach(std::span<const MasterFace> faces, std::span<const NodeMotion> motion, double dt, double capture,
                   std::vector<FaceReach>& reach) {
  reach.clear();
  std::array<Vec3, 4> corners;
  for (const MasterFace& face : faces) {
    Box sweep;
    const auto count = static_cast<std::size_t>(face.corner_count);
    for (std::size_t i = 0; i < count; ++i) {
      const NodeMotion& corner = motion[static_cast<std::size_t>(face.nodes[i])];
      extend_by_sweep(sweep, corner, dt);
      corners[i] = corner.position;
    }
    const double size = geometry::longest_edge({corners.data(), count});
    reach.push_back({geometry::grown(sweep, capture * size), size});
  }
}

double opposition(const Vec3& normal, std::span<const LocalIndex> facets, std::span<const Vec3> facet_normal) {
  double least = 1;
  for (const LocalIndex facet : facets)
    least = std::min(least, facet_normal[static_cast<std::size_t>(facet)].dot(normal));
  return -least;
}

Row row_of(const Encounter& e, const MasterFace& face, LocalIndex slave) {
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
  return row;
}

/// One slave node's encounters with all faces near it, body by body, those with Meeting::none included.
void meet_faces(const FacesInMotion& scene, const DetectionSettings& all_settings, const NodeMotion& slave,
                std::span<const LocalIndex> near, std::span<const LocalIndex> facets, DetectionScratch& scratch) {
  const EncounterSettings& settings = all_settings.encounter;
  Box sweep;
  extend_by_sweep(sweep, slave, scene.dt);
  std::vector<Encounter>& met = scratch.encounters;
  met.clear();
  for (std::size_t i = 0; i < near.size();) {
    const std::int32_t body = scene.faces[static_cast<std::size_t>(near[i])].body;
    const std::size_t first = met.size();
    for (; i < near.size() && scene.faces[static_cast<std::size_t>(near[i])].body == body; ++i)
      if (geometry::overlaps(scene.reach[static_cast<std::size_t>(near[i])].box, sweep)) {
        met.push_back(encounter(scene, settings, slave, near[i]));
        met.back().opposition = opposition(met.back().normal, facets, scratch.facet_normal);
      }
    settle_rims(scene.faces, settings, all_settings.choice.same_direction, std::span(met).subspan(first));
    judge_paths(scene, settings, slave, std::span(met).subspan(first));
  }
  std::erase_if(met, [](const Encounter& e) { return e.meeting == Meeting::none; });
}

double accepted_depth(std::span<const AcceptedOverlap> accepted, GlobalIndex slave, std::int32_t body) {
  if (accepted.empty()) return 0;
  const auto before = [](const AcceptedOverlap& one, const std::pair<GlobalIndex, std::int32_t>& wanted) {
    return std::pair(one.slave, one.body) < wanted;
  };
  const auto found = std::lower_bound(accepted.begin(), accepted.end(), std::pair(slave, body), before);
  return found != accepted.end() && found->slave == slave && found->body == body ? found->depth : 0;
}

}  // namespace

double required_rate(double gap, double size, double dt, const DetectionSettings& settings) {
  if (gap >= 0) return -gap / dt;
  return std::min(-settings.recovery * gap, settings.recovery_limit * size) / dt;
}

void detect_faces(const Candidates& candidates, std::span<const MasterFace> faces, std::span<const GlobalIndex> gid,
                  std::span<const NodeMotion> motion, std::span<const Vec3> facet_area, double dt,
                  const DetectionSettings& settings, DetectionScratch& scratch, std::vector<Row>& rows) {
  measure_reach(faces, motion, dt, settings.encounter.capture, scratch.reach);
  scratch.facet_normal.clear();
  for (const Vec3& area : facet_area) scratch.facet_normal.push_back(area.normalized());
  const FacesInMotion scene{faces, scratch.reach, motion, dt};
  for (std::size_t s = 0; s < candidates.slave.size(); ++s) {
    const LocalIndex slave = candidates.slave[s];
    const NodeMotion& node = motion[static_cast<std::size_t>(slave)];
    meet_faces(scene, settings, node, candidates.faces.row(static_cast<LocalIndex>(s)),
               candidates.slave_facets.row(static_cast<LocalIndex>(s)), scratch);
    const std::size_t kept = choose(faces, motion, node, dt, settings.choice, scratch.encounters);
    for (const Encounter& e : std::span(scratch.encounters).first(kept)) {
      const MasterFace& face = faces[static_cast<std::size_t>(e.face)];
      const GlobalIndex slave_gid = gid[static_cast<std::size_t>(slave)];
      Row row = row_of(e, face, slave);
      row.gap += accepted_depth(settings.accepted, slave_gid, face.body);
      row.required = required_rate(row.gap, e.size, dt, settings);
      row.slave_gid = slave_gid;
      row.slave_body = candidates.body[s];
      rows.push_back(row);
    }
  }
}

}  // namespace brunt::contact
