// SPDX-License-Identifier: Apache-2.0
// Nodes against faces: the passes of detect_faces (detection.hpp), numbered as there.
#include <algorithm>
#include <array>
#include <utility>

#include "contact/data/tolerances.hpp"
#include "contact/detection/coincident_nodes.hpp"
#include "contact/detection/cones.hpp"
#include "contact/detection/detection.hpp"
#include "contact/detection/features.hpp"
#include "contact/detection/ledges.hpp"
#include "contact/detection/seams.hpp"
#include "contact/detection/sides.hpp"
#include "reach.hpp"

namespace brunt::contact {
namespace {

/// A slave node and its surroundings.
struct Slave {
  LocalIndex node;
  GlobalIndex gid;
  std::int32_t body;
  const NodeMotion& motion;
  double half_thickness;             ///< > 0 on a sheet, whose facets have two sides
  std::span<const LocalIndex> near;  ///< candidate faces, body by body
  std::span<const PairPass> pass;    ///< of each of near; empty: no bodies meet in two passes
  std::span<const CoincidentCandidate> coincident;
  std::span<const LocalIndex> facets;  ///< faces of its own surface
  std::span<const double> seam_sag;    ///< of each of facets, see Candidates; empty: there is no seam

  [[nodiscard]] bool on_sheet() const { return half_thickness > 0; }
};

/// Calls visit(first, end) for each run of items of one body.
template <class BodyAt, class Visit>
void for_each_body(std::size_t count, const BodyAt& body_at, const Visit& visit) {
  for (std::size_t first = 0, end = 0; first < count; first = end) {
    while (end < count && body_at(end) == body_at(first)) ++end;
    visit(first, end);
  }
}

class FaceDetection {
 public:
  FaceDetection(const StepView& step, const FaceInput& input, DetectionScratch& scratch)
      : step_(step),
        input_(input),
        candidates_(input.candidates),
        scratch_(scratch),
        scene_{input.faces, scratch.reach, step.motion, step.dt, *step.settings.tolerances} {}

  /// The slaves from `first` up to `end`, at most slaves_at_once.
  void append_rows(std::size_t first, std::size_t end, std::vector<Row>& rows) {
    std::array<std::size_t, slaves_at_once> end_of{};  // of the encounters of each slave
    scratch_.encounters.clear();
    scratch_.slave_of.clear();
    for (std::size_t s = first; s < end; ++s) {
      list_encounters(slave_at(s));  // pass 1
      end_of[s - first] = scratch_.encounters.size();
    }
    encounter_all(scene_, scratch_.slave_of, scratch_.encounters);  // 2
    for (std::size_t s = first, begin = 0; s < end; begin = end_of[s++ - first]) {
      if (begin == end_of[s - first]) continue;
      const Slave slave = slave_at(s);
      const std::span<Encounter> met =
          resolve(slave, std::span(scratch_.encounters).subspan(begin, end_of[s - first] - begin));
      if (any_sheets()) keep_sides(slave, met);
      append_selected(slave, met, rows);  // 8 and 9
    }
  }

 private:
  [[nodiscard]] bool any_sheets() const { return !candidates_.half_thickness.empty(); }

  [[nodiscard]] Slave slave_at(std::size_t s) const {
    const auto row = static_cast<LocalIndex>(s);
    const auto near = candidates_.faces.row(row);
    const auto facets = candidates_.slave_facets.row(row);
    const LocalIndex node = candidates_.slave[s];
    Slave slave{.node = node,
                .gid = nth(step_.gid, node),
                .body = candidates_.body[s],
                .motion = nth(step_.motion, node),
                .half_thickness = any_sheets() ? candidates_.half_thickness[s] : 0.0,
                .near = near,
                .pass = {},
                .coincident = {},
                .facets = facets,
                .seam_sag = {}};
    if (!candidates_.pass.empty()) {
      const auto place = static_cast<std::size_t>(near.data() - candidates_.faces.values.data());
      slave.pass = std::span(candidates_.pass).subspan(place, near.size());
      slave.coincident = candidates_.coincident.row(row);
    }
    if (!candidates_.seam_sag.empty())
      slave.seam_sag = {&nth(candidates_.seam_sag, candidates_.slave_facets.offsets[s]), facets.size()};
    return slave;
  }

  /// Pass 1 for all faces near the slave.
  void list_encounters(const Slave& slave) {
    const std::span<const HistoryRecord> remembered =
        any_sheets() ? next_records_of(slave.gid) : std::span<const HistoryRecord>{};
    const Sweep sweep = sweep_of(slave.motion, step_.dt, slave.half_thickness);
    for_each_body(
        slave.near.size(), [&](std::size_t i) { return scene_.face(slave.near[i]).body; },
        [&](std::size_t first, std::size_t end) {
          const std::size_t listed = scratch_.encounters.size();
          if (list_faces_of_body(slave, sweep, first, end))
            find_sides(scene_, slave.motion, remembered, std::span(scratch_.encounters).subspan(listed));
        });
    scratch_.slave_of.resize(scratch_.encounters.size(), &slave.motion);
  }

  /// The faces near[first .. end) of one body; returns whether any of them is two-sided.
  bool list_faces_of_body(const Slave& slave, const Sweep& sweep, std::size_t first, std::size_t end) {
    const std::size_t listed = scratch_.encounters.size();
    if (!input_.settled.empty() && nth(input_.settled, &slave.near[first] - candidates_.faces.values.data()) != 0)
      return false;
    RowsToSpare spare;
    if (!slave.coincident.empty())
      spare =
          rows_to_spare(scene_, {slave.motion, slave.facets, scratch_.facet_normal, slave.on_sheet()},
                        slave.near.subspan(first, end - first), slave.coincident, step_.settings.coincidence_distance);
    bool two_sided = false;
    for (std::size_t i = first; i < end; ++i) {
      if (spare.first && slave.pass[i] == PairPass::first) continue;
      if (spare.second && slave.pass[i] == PairPass::second) continue;
      if (!overlaps(nth(scene_.reach, slave.near[i]).box, sweep)) continue;
      const MasterFace& face = scene_.face(slave.near[i]);
      Encounter& e = scratch_.encounters.emplace_back();
      e.face = slave.near[i];
      e.approach.clearance = face.half_thickness + slave.half_thickness;
      two_sided = two_sided || face.two_sided;
    }
    if (!input_.held.empty() && all_are_held(slave, listed)) scratch_.encounters.resize(listed);
    return two_sided;
  }

  /// Whether mortar rows with the slave's body have all corners of all faces listed from `first` on.
  [[nodiscard]] bool all_are_held(const Slave& slave, std::size_t first) const {
    return std::all_of(scratch_.encounters.begin() + static_cast<std::ptrdiff_t>(first), scratch_.encounters.end(),
                       [&](const Encounter& e) {
                         const MasterFace& face = scene_.face(e);
                         const auto corners = std::span(face.nodes).first(static_cast<std::size_t>(face.corner_count));
                         return std::ranges::all_of(
                             corners, [&](LocalIndex node) { return nth(input_.held, node).has(slave.body); });
                       });
  }

  /// The records of a slave. To be called for the slaves in ascending order.
  std::span<const HistoryRecord> next_records_of(GlobalIndex slave) {
    const std::span<const HistoryRecord> all = input_.remembered;
    while (record_ < all.size() && all[record_].key.slave < slave) ++record_;
    std::size_t end = record_;
    while (end < all.size() && all[end].key.slave == slave) ++end;
    return all.subspan(record_, end - record_);
  }

  /// Passes 3 to 7. Returns the encounters in which something is met.
  std::span<Encounter> resolve(const Slave& slave, std::span<Encounter> encounters) const {
    measure_opposition({slave.facets, scratch_.facet_normal, slave.on_sheet()}, encounters);
    const auto body_at = [&](std::size_t i) { return scene_.face(encounters[i]).body; };
    for_each_body(encounters.size(), body_at, [&](std::size_t first, std::size_t end) {
      const std::span<Encounter> of_body = encounters.subspan(first, end - first);
      resolve_features(scene_, step_.settings.criterion, of_body);  // pass 4
      detect_path_hits(scene_, slave.motion, of_body);              // 5
      if (seams_count(step_.settings, slave.body, body_at(first)))  // 6
        remove_lateral_faces_of_seams(scene_, {slave.facets, slave.seam_sag, scratch_.facet_normal}, of_body);
      remove_lateral_faces_of_ledges(scene_, slave.motion, of_body);  // 7
    });
    const auto end = std::remove_if(encounters.begin(), encounters.end(),
                                    [](const Encounter& e) { return e.meeting == Meeting::none; });
    return encounters.first(static_cast<std::size_t>(end - encounters.begin()));
  }

  /// Pass 3: a face with a slight opposition is a lateral face, whose opposition is zero.
  void measure_opposition(const NormalCone& cone, std::span<Encounter> encounters) const {
    const bool smooth = is_smooth(cone, scene_.tolerances.aligned);
    for (Encounter& e : encounters) {
      const double cosine = admission(cone, e.normal, smooth);
      e.opposition = cosine < scene_.tolerances.slight ? 0 : cosine;
    }
  }

  /// The sides of the two-sided faces that the slave meets, in the order of their keys.
  void keep_sides(const Slave& slave, std::span<const Encounter> encounters) {
    const std::size_t first = scratch_.sides.size();
    for (const Encounter& e : encounters)
      if (const MasterFace& face = scene_.face(e); face.two_sided)
        scratch_.sides.push_back({.key = {.slave = slave.gid, .master = face.key}, .side = e.approach.side});
    std::ranges::sort(std::span(scratch_.sides).subspan(first), {}, &HistoryRecord::key);
  }

  /// Passes 8 and 9.
  void append_selected(const Slave& slave, std::span<Encounter> encounters, std::vector<Row>& rows) const {
    const std::size_t selected = select_rows(scene_, slave.motion, step_.settings.criterion, encounters);
    for (const Encounter& e : encounters.first(selected)) {
      Row& row = rows.emplace_back();
      fill_row(slave, e, row);
      shift_gap(slave, row);
      row.required = required_rate(row, row.gap, e.size, step_);
    }
  }

  void fill_row(const Slave& slave, const Encounter& e, Row& row) const {
    const MasterFace& face = scene_.face(e);
    row.key.slave = slave.gid;
    row.key.master = face.key;
    row.slave_body = slave.body;
    row.master_body = face.body;
    row.master_block = face.block;
    row.master_face = e.face;
    row.nodes[0] = slave.node;
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

  /// Measures the gap from an accepted overlap of the start, or from a birth.
  void shift_gap(const Slave& slave, Row& row) const {
    row.gap += accepted_penetration(step_.settings.accepted, slave.gid, row.master_body);
    if (input_.births.empty()) return;
    const BirthRecord* birth =
        find_birth(input_.births, {.kind = RowKind::face, .slave = slave.gid, .master = row.master_body});
    if (birth != nullptr) row.gap += birth->penetration;
  }

  const StepView& step_;
  const FaceInput& input_;
  const Candidates& candidates_;
  DetectionScratch& scratch_;
  FacesInMotion scene_;
  std::size_t record_ = 0;  ///< of the history, where the next slave's records are looked for
};

}  // namespace

void detect_faces(const StepView& step, const FaceInput& input, DetectionScratch& scratch, std::vector<Row>& rows) {
  measure_reach(input.faces, step.motion, step.dt, *step.settings.tolerances, scratch.reach);
  scratch.facet_normal.clear();
  for (const Vec3& area : input.facet_area) scratch.facet_normal.push_back(area.normalized());
  scratch.sides.clear();
  FaceDetection detection(step, input, scratch);
  const std::size_t slaves = input.candidates.slave.size();
  for (std::size_t first = 0; first < slaves; first += slaves_at_once)
    detection.append_rows(first, std::min(first + slaves_at_once, slaves), rows);
}

}  // namespace brunt::contact
