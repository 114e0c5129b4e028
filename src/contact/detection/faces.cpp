// SPDX-License-Identifier: Apache-2.0
// Node-to-face contact: the encounters of each slave, and the resulting rows.
#include <algorithm>
#include <cmath>
#include <utility>

#include "contact/data/tolerances.hpp"
#include "contact/detection/coincident_nodes.hpp"
#include "contact/detection/cones.hpp"
#include "contact/detection/detection.hpp"
#include "contact/detection/features.hpp"
#include "contact/detection/ledges.hpp"
#include "contact/detection/seams.hpp"
#include "contact/detection/sides.hpp"
#include "motion_quads.hpp"

namespace brunt::contact {
namespace {

using geometry::Box;

/// Box of what a node sweeps in the step; the fourth of each is beyond everything.
struct Sweep {
  Quad low, high;
};

BRUNT_INLINE Sweep sweep_of(const NodeMotion& node, double dt, double margin) {
  const Quad start = position_quad(node), end = start + dt * predicted_quad(node);
  Sweep sweep{(start < end ? start : end) - margin, (start > end ? start : end) + margin};
  sweep.low[3] = -std::numeric_limits<double>::infinity();
  sweep.high[3] = std::numeric_limits<double>::infinity();
  return sweep;
}

/// All six comparisons without branches, which would be mispredicted.
BRUNT_INLINE bool overlaps(const Box& box, const Sweep& sweep) {
  static_assert(sizeof(Box) == 6 * sizeof(double));
  const char* const six = reinterpret_cast<const char*>(&box);
  Quad low, last;  // the low corner and x of the high one; z of the low corner and the high one
  std::memcpy(&low, six, sizeof low);
  std::memcpy(&last, six + sizeof(Box) - sizeof last, sizeof last);
  const Quad high = __builtin_shufflevector(last, last, 1, 2, 3, 3);
  return all((low <= sweep.high) & (sweep.low <= high));
}

/// Longest edge [length]: geometry::longest_edge, but of corners as they lie here, since it is asked for of every face
/// in every step.
BRUNT_INLINE double size_of(const std::array<Quad, 4>& corners, std::size_t count) {
  double longest2 = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const Quad edge = corners[i + 1 < count ? i + 1 : 0] - corners[i], square = edge * edge;
    longest2 = std::max(longest2, square[0] + square[1] + square[2]);
  }
  return std::sqrt(longest2);
}

FaceReach reach_of(const MasterFace& face, std::span<const NodeMotion> motion, double dt,
                   const Tolerances& tolerances) {
  const auto count = static_cast<std::size_t>(face.corner_count);
  std::array<Quad, 4> corners{};
  Quad low{}, high{};
  for (std::size_t i = 0; i < count; ++i) {
    const NodeMotion& corner = motion[static_cast<std::size_t>(face.nodes[i])];
    corners[i] = position_quad(corner);
    const Quad end = corners[i] + dt * predicted_quad(corner);
    if (i == 0) low = high = end;
    low = low < end ? low : end;
    low = low < corners[i] ? low : corners[i];
    high = high > end ? high : end;
    high = high > corners[i] ? high : corners[i];
  }
  FaceReach reach{.box = {}, .size = size_of(corners, count)};
  const double margin = tolerances.reach(reach.size, face.element_depth) + face.half_thickness;
  reach.box = geometry::grown({Vec3(low[0], low[1], low[2]), Vec3(high[0], high[1], high[2])}, margin);
  return reach;
}

void measure_reach(std::span<const MasterFace> faces, std::span<const NodeMotion> motion, double dt,
                   const Tolerances& tolerances, std::vector<FaceReach>& reach) {
  reach.clear();
  for (const MasterFace& face : faces) reach.push_back(reach_of(face, motion, dt, tolerances));
}

/// A slave node with what lies around it.
struct Slave {
  const NodeMotion& motion;
  std::span<const LocalIndex> near, facets;
  std::span<const PairPass> pass;  ///< of near; empty: none
  std::span<const CoincidentCandidate> coincident;
  double half_thickness;  ///< > 0 on a sheet, whose facets look to both sides
  std::span<const HistoryRecord> remembered;
  std::int32_t body = 0;
  std::span<const double> seam_sag{};  ///< of facets, see Candidates; empty: none
};

/// Faces that the slave's cone hardly admits are sides, along which it slides: they oppose it by nothing.
void measure_opposition(const NormalCone& cone, const Tolerances& tolerances, std::span<Encounter> encounters) {
  const bool smooth = is_smooth(cone, tolerances.aligned);
  for (Encounter& e : encounters) {
    const double cosine = admission(cone, e.normal, smooth);
    e.opposition = cosine < tolerances.slight ? 0 : cosine;
  }
}

void fill_row(const Encounter& e, const MasterFace& face, LocalIndex slave, Row& row) {
  row.key.master = face.key;
  row.master_body = face.body;
  row.master_block = face.block;
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
}

/// The faces of one body near a slave, as encounters of which face and approach are set. pass: of each, or none.
void list_faces_of_body(const FacesInMotion& scene, const DetectionSettings& settings, const Slave& slave,
                        const Sweep& sweep, std::span<const LocalIndex> near, std::span<const PairPass> pass,
                        std::span<const Vec3> facet_normal, std::vector<Encounter>& encounters) {
  RowsToSpare spare;
  if (!slave.coincident.empty())
    spare = rows_to_spare(scene, {slave.motion, slave.facets, facet_normal, slave.half_thickness > 0}, near,
                          slave.coincident, settings.coincidence_distance, *settings.tolerances);
  const std::size_t first = encounters.size();
  bool two_sided = false;
  for (std::size_t i = 0; i < near.size(); ++i) {
    if (spare.first && pass[i] == PairPass::first) continue;
    if (spare.second && pass[i] == PairPass::second) continue;
    if (!overlaps(scene.reach[static_cast<std::size_t>(near[i])].box, sweep)) continue;
    const MasterFace& face = scene.faces[static_cast<std::size_t>(near[i])];
    Encounter& e = encounters.emplace_back();
    e.face = near[i];
    e.approach.clearance = face.half_thickness + slave.half_thickness;
    two_sided = two_sided || face.two_sided;
  }
  if (two_sided)
    find_sides(scene, *settings.tolerances, slave.motion, slave.remembered, std::span(encounters).subspan(first));
}

/// The same of all faces near it, body by body.
void list_faces(const FacesInMotion& scene, const DetectionSettings& settings, const Slave& slave,
                DetectionScratch& scratch) {
  const Sweep sweep = sweep_of(slave.motion, scene.dt, slave.half_thickness);
  const auto body_at = [&](std::size_t i) { return scene.faces[static_cast<std::size_t>(slave.near[i])].body; };
  for (std::size_t first = 0, end = 0; first < slave.near.size(); first = end) {
    while (end < slave.near.size() && body_at(end) == body_at(first)) ++end;
    const auto pass = slave.pass.empty() ? slave.pass : slave.pass.subspan(first, end - first);
    list_faces_of_body(scene, settings, slave, sweep, slave.near.subspan(first, end - first), pass,
                       scratch.facet_normal, scratch.encounters);
  }
  scratch.slave_of.resize(scratch.encounters.size(), &slave.motion);
}

/// One slave node's encounters with all faces near it, body by body; returns those where something is met.
std::span<Encounter> meet_faces(const FacesInMotion& scene, const DetectionSettings& settings, const Slave& slave,
                                std::span<const Vec3> facet_normal, std::span<Encounter> encounters) {
  const auto body_of = [&](const Encounter& e) { return scene.faces[static_cast<std::size_t>(e.face)].body; };
  const Tolerances& tolerances = *settings.tolerances;
  measure_opposition({slave.facets, facet_normal, slave.half_thickness > 0}, tolerances, encounters);
  for (std::size_t first = 0, last = 0; first < encounters.size(); first = last) {
    while (last < encounters.size() && body_of(encounters[last]) == body_of(encounters[first])) ++last;
    const std::span<Encounter> here = encounters.subspan(first, last - first);
    resolve_features(scene, tolerances, settings.criterion, here);
    detect_path_hits(scene, tolerances, slave.motion, here);
    if (seams_count(settings, slave.body, body_of(here.front())))
      remove_seam_sides(scene, tolerances, {slave.facets, slave.seam_sag, facet_normal}, here);
    remove_ledge_sides(scene, tolerances, slave.motion, here);
  }
  const auto end = std::remove_if(encounters.begin(), encounters.end(),
                                  [](const Encounter& e) { return e.meeting == Meeting::none; });
  return encounters.first(static_cast<std::size_t>(end - encounters.begin()));
}

/// The records of a slave; `from` moves on with the slaves, which ascend.
std::span<const HistoryRecord> records_of(GlobalIndex slave, std::span<const HistoryRecord> remembered,
                                          std::size_t& from) {
  while (from < remembered.size() && remembered[from].key.slave < slave) ++from;
  std::size_t end = from;
  while (end < remembered.size() && remembered[end].key.slave == slave) ++end;
  return remembered.subspan(from, end - from);
}

void keep_sides(const FacesInMotion& scene, GlobalIndex slave, std::span<const Encounter> encounters,
                DetectionScratch& scratch) {
  const std::size_t first = scratch.sides.size();
  for (const Encounter& e : encounters)
    if (const MasterFace& face = scene.faces[static_cast<std::size_t>(e.face)]; face.two_sided)
      scratch.sides.push_back({.key = {.slave = slave, .master = face.key}, .side = e.approach.side});
  std::ranges::sort(std::span(scratch.sides).subspan(first), {}, &HistoryRecord::key);
}

/// The rows of one slave, from what it meets.
void add_rows(const FacesInMotion& scene, const Candidates& candidates, std::size_t s, std::span<const GlobalIndex> gid,
              const DetectionSettings& settings, std::span<const BirthRecord> births, std::span<Encounter> encounters,
              std::vector<Row>& rows) {
  const LocalIndex node = candidates.slave[s];
  const GlobalIndex slave_gid = gid[static_cast<std::size_t>(node)];
  const NodeMotion& motion = scene.motion[static_cast<std::size_t>(node)];
  const std::size_t kept =
      select_rows(scene.faces, scene.motion, motion, scene.dt, settings.criterion, *settings.tolerances, encounters);
  for (const Encounter& e : encounters.first(kept)) {
    const MasterFace& face = scene.faces[static_cast<std::size_t>(e.face)];
    Row& row = rows.emplace_back();
    fill_row(e, face, node, row);
    row.key.slave = slave_gid;
    row.slave_body = candidates.body[s];
    row.gap += accepted_penetration(settings.accepted, slave_gid, face.body);
    if (!births.empty())
      if (const BirthRecord* birth =
              find_birth(births, {.kind = RowKind::face, .slave = slave_gid, .master = face.body}))
        row.gap += birth->penetration;
    row.required = required_rate(row, e.size, scene.dt, scene.motion, settings);
  }
}

bool are_fitted(std::span<const BodyPair> fitted, const Row& row) {
  return std::ranges::binary_search(fitted, BodyPair(std::minmax(row.slave_body, row.master_body)));
}

}  // namespace

double accepted_penetration(std::span<const AcceptedOverlap> accepted, GlobalIndex slave, std::int32_t body) {
  if (accepted.empty()) return 0;
  const auto before = [](const AcceptedOverlap& one, const std::pair<GlobalIndex, std::int32_t>& wanted) {
    return std::pair(one.slave, one.body) < wanted;
  };
  const auto found = std::lower_bound(accepted.begin(), accepted.end(), std::pair(slave, body), before);
  return found != accepted.end() && found->slave == slave && found->body == body ? found->penetration : 0;
}

double recovery_time(const Row& row, double size, double dt, const DetectionSettings& settings) {
  const std::vector<double>& sound = settings.sound;
  if (sound.empty()) return dt;
  double slower = sound[static_cast<std::size_t>(row.slave_body)];
  if (!row.is_wall()) slower = std::min(slower, sound[static_cast<std::size_t>(row.master_body)]);
  return std::max(dt, settings.tolerances->recovery_time * size / slower);
}

double required_rate(const Row& row, double size, double dt, std::span<const NodeMotion> motion,
                     const DetectionSettings& settings) {
  if (row.gap >= 0) return -row.gap / dt;
  const double time = recovery_time(row, size, dt, settings);
  const Tolerances& tolerances = *settings.tolerances;
  const double recovery = std::min(-tolerances.recovery * row.gap, tolerances.recovery_limit * size) / time;
  const bool fitted = are_fitted(settings.fitted, row);
  if (!fitted && (settings.recovery_gives || !row.is_edge())) return recovery;
  if (-row.gap <= (fitted ? tolerances.touching : tolerances.drift) * size) return recovery;
  const Vec3 relative = relative_velocity(
      row, [&](LocalIndex node) -> const Vec3& { return motion[static_cast<std::size_t>(node)].old_velocity; });
  return std::clamp(-row.normal.dot(relative), 0.0, recovery);
}

void detect_faces(const Candidates& candidates, std::span<const MasterFace> faces, std::span<const GlobalIndex> gid,
                  std::span<const NodeMotion> motion, std::span<const Vec3> facet_area, double dt,
                  const DetectionSettings& settings, std::span<const HistoryRecord> remembered,
                  DetectionScratch& scratch, std::vector<Row>& rows, std::span<const BirthRecord> births) {
  measure_reach(faces, motion, dt, *settings.tolerances, scratch.reach);
  scratch.facet_normal.clear();
  for (const Vec3& area : facet_area) scratch.facet_normal.push_back(area.normalized());
  scratch.sides.clear();
  const FacesInMotion scene{faces, scratch.reach, motion, dt};
  const bool sheets = !candidates.half_thickness.empty();
  std::size_t record = 0;
  const std::span<const PairPass> pass = candidates.pass;
  const auto seam_sag = [&](std::size_t s) -> std::span<const double> {
    if (candidates.seam_sag.empty()) return {};
    const auto facets = candidates.slave_facets.row(static_cast<LocalIndex>(s));
    return {&candidates.seam_sag[static_cast<std::size_t>(candidates.slave_facets.offsets[s])], facets.size()};
  };
  const auto slave_at = [&](std::size_t s) {
    const auto near = candidates.faces.row(static_cast<LocalIndex>(s));
    const auto place = static_cast<std::size_t>(near.data() - candidates.faces.values.data());
    return Slave{.motion = motion[static_cast<std::size_t>(candidates.slave[s])],
                 .near = near,
                 .facets = candidates.slave_facets.row(static_cast<LocalIndex>(s)),
                 .pass = pass.empty() ? pass : pass.subspan(place, near.size()),
                 .coincident = pass.empty() ? std::span<const CoincidentCandidate>{}
                                            : candidates.coincident.row(static_cast<LocalIndex>(s)),
                 .half_thickness = sheets ? candidates.half_thickness[s] : 0.0,
                 .remembered = {},
                 .body = candidates.body[s],
                 .seam_sag = seam_sag(s)};
  };
  std::array<std::size_t, slaves_at_once> last_of{};
  for (std::size_t first = 0; first < candidates.slave.size(); first += slaves_at_once) {
    const std::size_t end = std::min(first + slaves_at_once, candidates.slave.size());
    scratch.encounters.clear();
    scratch.slave_of.clear();
    for (std::size_t s = first; s < end; ++s) {
      Slave slave = slave_at(s);
      if (sheets) slave.remembered = records_of(gid[static_cast<std::size_t>(candidates.slave[s])], remembered, record);
      list_faces(scene, settings, slave, scratch);
      last_of[s - first] = scratch.encounters.size();
    }
    encounter_all(scene, *settings.tolerances, scratch.slave_of, scratch.encounters);
    for (std::size_t s = first, begin = 0; s < end; begin = last_of[s++ - first]) {
      if (begin == last_of[s - first]) continue;
      const std::span<Encounter> encounters =
          meet_faces(scene, settings, slave_at(s), scratch.facet_normal,
                     std::span(scratch.encounters).subspan(begin, last_of[s - first] - begin));
      if (sheets) keep_sides(scene, gid[static_cast<std::size_t>(candidates.slave[s])], encounters, scratch);
      add_rows(scene, candidates, s, gid, settings, births, encounters, rows);
    }
  }
}

}  // namespace brunt::contact
