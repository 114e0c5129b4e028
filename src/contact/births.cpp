// SPDX-License-Identifier: Apache-2.0
#include "brunt/contact/births.hpp"

#include <algorithm>

namespace brunt::contact {
namespace {

AnchorKey key_of(const Row& row) {
  return {.kind = RowKind::face, .slave = row.key.slave, .master = row.master_body};
}

bool is_of_face(const Row& row) {
  return row.key.kind == RowKind::face;
}

}  // namespace

void begin_births(std::span<const HistoryRecord> acted, std::vector<Row>& rows, std::vector<BirthRecord>& births) {
  std::vector<BirthRecord> born;
  for (Row& row : rows) {
    if (!is_of_face(row) || row.gap >= 0) continue;
    const auto before = std::ranges::lower_bound(acted, row.key, {}, &HistoryRecord::key);
    if (before != acted.end() && before->key == row.key) continue;
    born.push_back({key_of(row), -row.gap});
  }
  if (born.empty()) return;
  std::ranges::sort(born, {}, &BirthRecord::key);
  std::vector<BirthRecord> deepest;  // of the faces of a body, on top of what the node was born with before
  for (const BirthRecord& record : born)
    if (!deepest.empty() && deepest.back().key == record.key)
      deepest.back().penetration = std::max(deepest.back().penetration, record.penetration);
    else
      deepest.push_back(record);
  for (Row& row : rows) {
    if (!is_of_face(row) || row.gap >= 0) continue;
    if (const BirthRecord* record = find_birth(deepest, key_of(row))) {
      row.gap += record->penetration;
      row.required = 0;
    }
  }
  for (const BirthRecord& record : deepest) {
    const auto at = std::ranges::lower_bound(births, record.key, {}, &BirthRecord::key);
    if (at != births.end() && at->key == record.key)
      at->penetration += record.penetration;
    else
      births.insert(at, record);
  }
}

void fade_births(std::span<const Row> rows, std::vector<BirthRecord>& births) {
  if (births.empty()) return;
  std::vector<double> depth(births.size(), 0.0);
  for (const Row& row : rows) {
    if (!is_of_face(row)) continue;
    const BirthRecord* record = find_birth(births, key_of(row));
    if (record == nullptr) continue;
    double& deepest = depth[static_cast<std::size_t>(record - births.data())];
    deepest = std::max(deepest, record->penetration - row.gap);
  }
  for (std::size_t k = 0; k < births.size(); ++k) births[k].penetration = std::min(births[k].penetration, depth[k]);
  std::erase_if(births, [](const BirthRecord& record) { return !(record.penetration > 0); });
}

}  // namespace brunt::contact
