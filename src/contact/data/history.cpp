// SPDX-License-Identifier: Apache-2.0
#include "contact/data/history.hpp"

#include <algorithm>
#include <utility>

#include "contact/data/row_matrix.hpp"
#include "contact/data/tolerances.hpp"
#include "core/error.hpp"

namespace brunt::contact {
namespace {

bool acted(const HistoryRecord& record) {
  return std::ranges::any_of(record.force, [](double component) { return component != 0; });
}

/// Rows and records of one slave: those of the same keys belong together, then, each once, those that point alike.
/// aligned: Tolerances::aligned; friction may tilt a force by 20 degrees.
void start_slave(std::span<const Row> rows, std::span<const HistoryRecord> records, double dt, double aligned,
                 std::span<Vec3> impulses) {
  const auto has_record = [&](const Row& row) {
    return std::ranges::any_of(records, [&](const HistoryRecord& record) { return record.key == row.key; });
  };
  for (const HistoryRecord& record : records) {
    const Vec3 force(record.force.data());
    const auto own = std::ranges::find(rows, record.key, &Row::key);
    if (own != rows.end()) {
      nth(impulses, own - rows.begin()) = admitted(law_of(*own), dt * force);
      continue;
    }
    if (record.key.kind == RowKind::wall || !acted(record)) continue;  // walls have no next face
    std::size_t best = rows.size();
    double most = aligned * force.norm();
    for (std::size_t q = 0; q < rows.size(); ++q) {
      if (rows[q].is_wall() || !impulses[q].isZero(0) || has_record(rows[q])) continue;
      const double along = rows[q].normal.dot(force);
      if (along <= most) continue;
      most = along;
      best = q;
    }
    if (best < rows.size()) impulses[best] = admitted(law_of(rows[best]), dt * force);
  }
}

}  // namespace

const AnchorRecord* find_anchor(std::span<const AnchorRecord> anchors, const AnchorKey& key) {
  const auto found = std::ranges::lower_bound(anchors, key, {}, &AnchorRecord::key);
  return found != anchors.end() && found->key == key ? &*found : nullptr;
}

const BirthRecord* find_birth(std::span<const BirthRecord> births, const AnchorKey& key) {
  const auto found = std::ranges::lower_bound(births, key, {}, &BirthRecord::key);
  return found != births.end() && found->key == key ? &*found : nullptr;
}

void start_impulses(std::span<const Row> rows, std::span<const HistoryRecord> records, double dt,
                    std::span<Vec3> impulses, const Tolerances& tolerances) {
  std::ranges::fill(impulses, Vec3::Zero());
  auto record = records.begin();
  for (std::size_t first = 0, last = 0; first < rows.size(); first = last) {
    const std::array<GlobalIndex, 2> slave = slave_of(rows[first].key);
    while (last < rows.size() && slave_of(rows[last].key) == slave) ++last;
    while (record != records.end() && slave_of(record->key) < slave) ++record;
    const auto begin = record;
    while (record != records.end() && slave_of(record->key) == slave) ++record;
    start_slave(rows.subspan(first, last - first), {begin, record}, dt, tolerances.aligned,
                impulses.subspan(first, last - first));
  }
}

void write_pairs(std::span<const Row> rows, std::span<const Vec3> impulses, double dt,
                 std::span<const HistoryRecord> sides, std::vector<HistoryRecord>& records,
                 std::span<const char> unmet) {
  records.clear();
  auto side = sides.begin();
  for (std::size_t q = 0; q < rows.size(); ++q) {
    const RowKey& key = rows[q].key;
    for (; side != sides.end() && side->key < key; ++side) records.push_back(*side);
    const bool two_sided = side != sides.end() && side->key == key;
    const bool is_unmet = !unmet.empty() && unmet[q] != 0;
    if (impulses[q].isZero(0) && !two_sided && !is_unmet) continue;
    const Vec3 force = impulses[q] / dt;
    records.push_back({key, {force[0], force[1], force[2]}, two_sided ? side->side : 0.0, is_unmet ? 1.0 : 0.0});
    if (two_sided) ++side;
  }
  records.insert(records.end(), side, sides.end());
}

void to_tables(const History& history, HistoryTables& tables) {
  tables[0] = {.name = "contact_pairs", .key_width = 4, .value_width = 5};
  for (const auto& [key, force, side, unmet] : history.pairs) {
    const SavedKey numbers = saved(key);
    tables[0].keys.insert(tables[0].keys.end(), numbers.begin(), numbers.end());
    tables[0].values.insert(tables[0].values.end(), {force[0], force[1], force[2], side, unmet});
  }
  tables[1] = {.name = "contact_anchors", .key_width = 5, .value_width = 7};
  for (const AnchorRecord& anchor : history.anchors) {
    const SavedKey numbers = saved(anchor.key);
    tables[1].keys.insert(tables[1].keys.end(), numbers.begin(), numbers.end());
    tables[1].keys.push_back(anchor.key.kind == RowKind::face ? anchor.face : -1);
    std::vector<double>& values = tables[1].values;
    values.insert(values.end(), anchor.weights.begin(), anchor.weights.end());
    values.insert(values.end(), anchor.on_wall.begin(), anchor.on_wall.end());
  }
  tables[2] = {.name = "contact_limits", .key_width = 4, .value_width = 1};
  for (const LimitRecord& record : history.limits) {
    const SavedKey numbers = saved(record.key);
    tables[2].keys.insert(tables[2].keys.end(), numbers.begin(), numbers.end());
    tables[2].values.push_back(record.limit);
  }
  tables[3] = {.name = "contact_births", .key_width = 4, .value_width = 2};
  for (const BirthRecord& record : history.births) {
    const SavedKey numbers = saved(record.key);
    tables[3].keys.insert(tables[3].keys.end(), numbers.begin(), numbers.end());
    tables[3].values.insert(tables[3].values.end(), {record.penetration, record.depth});
  }
  auto [heads, terms] = mortar_tables(history.mortar);
  tables[4] = std::move(heads);
  tables[5] = std::move(terms);
  tables[6] = impact_table(history.impacts);
}

History from_tables(const HistoryTables& tables) {
  History history;
  const RecordTable &pairs = tables[0], &anchors = tables[1], &limits = tables[2], &births = tables[3];
  demand(pairs.values.size() == 5 * static_cast<std::size_t>(pairs.rows()) &&
             anchors.values.size() == 7 * static_cast<std::size_t>(anchors.rows()) &&
             limits.values.size() == static_cast<std::size_t>(limits.rows()) &&
             births.values.size() == 2 * static_cast<std::size_t>(births.rows()),
         "the tables of contact's history are complete");
  const double* value = pairs.values.data();
  for (auto key = pairs.keys.begin(); key != pairs.keys.end(); key += 4, value += 5)
    history.pairs.push_back(
        {row_key_from({key[0], key[1], key[2], key[3]}), {value[0], value[1], value[2]}, value[3], value[4]});
  value = anchors.values.data();
  for (auto key = anchors.keys.begin(); key != anchors.keys.end(); key += 5, value += 7) {
    AnchorRecord anchor{.key = anchor_key_from({key[0], key[1], key[2], key[3]})};
    if (anchor.key.kind == RowKind::face) anchor.face = key[4];
    std::copy_n(value, 4, anchor.weights.begin());
    std::copy_n(value + 4, 3, anchor.on_wall.begin());
    history.anchors.push_back(anchor);
  }
  value = limits.values.data();
  for (auto key = limits.keys.begin(); key != limits.keys.end(); key += 4)
    history.limits.push_back({.key = anchor_key_from({key[0], key[1], key[2], key[3]}), .limit = *value++});
  value = births.values.data();
  for (auto key = births.keys.begin(); key != births.keys.end(); key += 4, value += 2)
    history.births.push_back({anchor_key_from({key[0], key[1], key[2], key[3]}), value[0], value[1]});
  history.impacts = impacts_from(tables[6]);
  std::ranges::sort(history.births, {}, &BirthRecord::key);
  std::ranges::sort(history.pairs, {}, &HistoryRecord::key);
  std::ranges::sort(history.anchors, {}, &AnchorRecord::key);
  std::ranges::sort(history.limits, {}, &LimitRecord::key);
  return history;
}

}  // namespace brunt::contact
