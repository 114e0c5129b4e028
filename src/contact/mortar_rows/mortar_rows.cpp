// SPDX-License-Identifier: Apache-2.0
#include "contact/mortar_rows/mortar_rows.hpp"

#include <algorithm>
#include <cmath>

#include "contact/data/tolerances.hpp"
#include "contact/mortar_rows/placed_row.hpp"

namespace brunt::contact {
namespace {

/// Farther than the bodies may move against each other in the step.
bool is_out_of_reach(const Row& row, double size, const StepView& step) {
  const Vec3 relative =
      relative_velocity(row, [&](LocalIndex node) -> const Vec3& { return nth(step.motion, node).predicted; });
  return row.gap > step.settings.tolerances->ledge * size + 2 * step.dt * relative.norm();
}

/// The row without its rate.
Row row_of(const KeptRow& kept, const PlacedRow& placed, const MortarScene& scene, std::span<const double> weights) {
  Row row{.key = kept.head.key};
  row.slave_body = nth(scene.candidates.facets, kept.places[kept.nodes]).body;
  row.master_body = static_cast<std::int32_t>(kept.head.key.master);
  row.master_block = kept.head.block;
  row.normal = placed.normal;
  row.gap = placed.gap + kept.head.born;
  row.wide_points = kept.places.first(kept.nodes);
  row.wide_weights = weights;
  row.node_count = 2;
  for (std::size_t i = 0; i < 2; ++i) {
    row.nodes[i] = row.wide_points[i];
    row.weights[i] = weights[i];
  }
  return row;
}

bool sticks(const Row& row, const Vec3& impulse, const Tolerances& tolerances) {
  const double push = row.normal.dot(impulse);
  return (impulse - push * row.normal).norm() < (1 - tolerances.fine_rounding) * friction_limit(row, push);
}

/// Calls visit(row, head) for rows with a kept one; both in order of their keys.
template <class Rows, class Heads, class Visit>
void for_each_pair(Rows& rows, Heads& heads, const Visit& visit) {
  std::size_t r = 0;
  for (std::size_t q = 0; q < rows.size(); ++q) {
    if (!rows[q].is_mortar()) continue;
    while (r < heads.size() && heads[r].key < rows[q].key) ++r;
    if (r < heads.size() && heads[r].key == rows[q].key) visit(q, heads[r]);
  }
}

}  // namespace

void append_mortar_rows(const StepView& step, const MortarScene& scene, std::span<const LocalIndex> places,
                        MortarHistory& history, MortarScratch& scratch, std::vector<Row>& rows) {
  scratch.normal.clear();
  scratch.weights.resize(history.terms.values.size());
  std::ranges::transform(history.terms.values, scratch.weights.begin(), &MortarTerm::weight);
  for (std::size_t r = 0; r < history.heads.size(); ++r) {
    const KeptRow kept = kept_row(history, places, r);
    const auto first = static_cast<std::size_t>(history.terms.offsets[r]);
    const std::span<double> weights = std::span(scratch.weights).subspan(first, kept.nodes);
    const PlacedRow placed = place_row(kept, scene, scratch.facet_normal, scratch.apart[r], weights);
    MortarHead& head = history.heads[r];
    head.born = std::clamp(-placed.gap, 0.0, head.born);
    scratch.normal.push_back(placed.normal);
    Row row = row_of(kept, placed, scene, weights);
    if (is_out_of_reach(row, head.size, step)) continue;
    row.required = required_rate(row, row.gap, head.size, step);
    rows.push_back(row);
  }
}

void aim_at_slips(std::span<Row> rows, const MortarHistory& history, const SlipRecovery& recovery, double dt) {
  for_each_pair(rows, history.heads, [&](std::size_t q, const MortarHead& head) {
    Row& row = rows[q];
    if (!(row.friction > 0)) return;
    const Vec3 slip(head.slip.data()), across = slip - row.normal.dot(slip) * row.normal;
    const double size = across.norm();
    if (size == 0) return;
    row.drift_share = std::min(recovery.share, recovery.limit / size);
    row.drift = -row.drift_share / dt * across;
  });
}

void tilt_mortar_rows(std::span<Row> rows, const MortarHistory& history, const TiltScene& scene, TiltStore& store) {
  for_each_pair(rows, history.heads, [&](std::size_t q, const MortarHead& head) {
    if (!has_tilts(rows[q])) return;
    const auto r = static_cast<LocalIndex>(&head - history.heads.data());
    const std::span<const MortarTerm> terms = history.terms.row(r);
    tilt_row(rows[q], scene, store,
             [&](std::size_t i) { return terms[i].part == MortarPart::master ? terms[i].reach : 0.0; });
  });
}

void keep_slips(std::span<const Row> rows, std::span<const Vec3> impulses, std::span<const Vec3> slid, double dt,
                const Tolerances& tolerances, MortarHistory& history) {
  std::size_t next = 0;
  const auto forget_up_to = [&](std::size_t end) {  // rows that were out of reach
    for (; next < end; ++next) history.heads[next].slip = {};
  };
  for_each_pair(rows, history.heads, [&](std::size_t q, MortarHead& head) {
    const auto r = static_cast<std::size_t>(&head - history.heads.data());
    forget_up_to(r);
    next = r + 1;
    const Row& row = rows[q];
    const bool rubs = row.friction > 0 && row.normal.dot(impulses[q]) > 0;
    Vec3 slip = rubs ? Vec3(Vec3(head.slip.data()) + dt * row.drift) : Vec3(Vec3::Zero());
    if (rubs && sticks(row, impulses[q], tolerances)) slip += slid[q];
    slip -= row.normal.dot(slip) * row.normal;
    head.slip = {slip[0], slip[1], slip[2]};
  });
  forget_up_to(history.heads.size());
}

}  // namespace brunt::contact
