// SPDX-License-Identifier: Apache-2.0
#include "contact/births.hpp"

#include <algorithm>

namespace brunt::contact {
namespace {

AnchorKey key_of(const Row& row) {
  return {.kind = RowKind::face, .slave = row.key.slave, .master = row.master_body};
}

bool is_of_face(const Row& row) {
  return row.key.kind == RowKind::face;
}

bool has_acted(std::span<const HistoryRecord> acted, const RowKey& key) {
  const auto record = std::ranges::lower_bound(acted, key, {}, &HistoryRecord::key);
  return record != acted.end() && record->key == key;
}

/// What of the row's penetration beyond the birth has not come about by motion [length].
double unexplained(const Row& row, const BirthRecord& before, const BirthScene& scene) {
  if (row.gap >= 0 || has_acted(scene.acted, row.key)) return 0;
  if (scene.surface_is_new) return -row.gap;
  const Vec3 relative =
      relative_velocity(row, [&](LocalIndex node) -> const Vec3& { return nth(scene.motion, node).old_velocity; });
  const double was = std::max(0.0, before.depth - before.penetration);
  const double motion = scene.only_approach ? std::max(0.0, -row.normal.dot(relative)) : relative.norm();
  return std::max(0.0, -row.gap - was - scene.dt * motion);
}

/// One record a node and body: the deepest.
void join_alike(std::vector<BirthRecord>& records) {
  std::ranges::sort(records, {}, &BirthRecord::key);
  std::size_t kept = 0;
  for (const BirthRecord& record : records) {
    if (kept == 0 || records[kept - 1].key != record.key) {
      records[kept++] = record;
      continue;
    }
    BirthRecord& same = records[kept - 1];
    same.penetration = std::max(same.penetration, record.penetration);
    same.depth = std::max(same.depth, record.depth);
  }
  records.resize(kept);
}

}  // namespace

void follow_births(const BirthScene& scene, std::vector<Row>& rows, std::vector<BirthRecord>& births,
                   std::vector<BirthRecord>& scratch) {
  const auto before = [&](const Row& row) {
    const BirthRecord* record = find_birth(births, key_of(row));
    return record != nullptr ? *record : BirthRecord{.key = key_of(row)};
  };
  scratch.clear();
  for (const Row& row : rows) {
    if (!is_of_face(row)) continue;
    BirthRecord record = before(row);
    const double depth = record.penetration - row.gap;
    if (!(depth > 0)) continue;
    record.penetration += unexplained(row, record, scene);
    record.depth = depth;
    scratch.push_back(record);
  }
  join_alike(scratch);
  for (Row& row : rows) {
    if (!is_of_face(row) || row.gap >= 0) continue;
    const BirthRecord* now = find_birth(scratch, key_of(row));
    const double born = now->penetration - before(row).penetration;
    if (!(born > 0)) continue;
    row.gap += born;
    row.required = 0;
  }
  for (BirthRecord& record : scratch) record.penetration = std::min(record.penetration, record.depth);
  births.swap(scratch);
}

}  // namespace brunt::contact
