// SPDX-License-Identifier: Apache-2.0
#include "contact/data/impact_history.hpp"

#include <algorithm>
#include <tuple>

#include "contact/data/history.hpp"
#include "core/error.hpp"

namespace brunt::contact {
namespace {

constexpr int impact_width = 5;

/// A total order, so that sums over the rows of one key do not depend on the order of rows.
auto place_of(const ImpactRecord& record) {
  const ImpactState& state = record.state;
  return std::tuple(record.key, state.bank, state.pressed, state.recent, state.most, state.flow);
}

ImpactState together(const ImpactState& one, const ImpactState& other) {
  return {one.bank + other.bank, std::max(one.pressed, other.pressed), std::max(one.recent, other.recent),
          std::max(one.most, other.most), std::max(one.flow, other.flow)};
}

}  // namespace

void read_impacts(std::span<const Row> rows, std::span<const ImpactRecord> records, std::span<ImpactState> states) {
  for (std::size_t first = 0, last = 0; first < rows.size(); first = last) {
    const std::array<GlobalIndex, 2> slave = slave_of(rows[first].key);
    while (last < rows.size() && slave_of(rows[last].key) == slave) ++last;
    for (std::size_t q = first; q < last; ++q) {
      states[q] = {};
      const AnchorKey key = anchor_key_of(rows[q]);
      const auto found = std::ranges::lower_bound(records, key, {}, &ImpactRecord::key);
      if (found == records.end() || !(found->key == key)) continue;
      states[q] = found->state;
      const auto sharers = std::count_if(rows.begin() + static_cast<std::ptrdiff_t>(first),
                                         rows.begin() + static_cast<std::ptrdiff_t>(last),
                                         [&](const Row& row) { return anchor_key_of(row) == key; });
      states[q].bank /= static_cast<double>(sharers);
    }
  }
}

void write_impacts(std::span<const Row> rows, std::span<const ImpactState> states, std::vector<ImpactRecord>& records) {
  records.clear();
  for (std::size_t q = 0; q < rows.size(); ++q)
    if (states[q].flow >= 0) records.push_back({anchor_key_of(rows[q]), states[q]});
  std::ranges::sort(records, {}, place_of);
  auto kept = records.begin();
  for (auto record = records.begin(); record != records.end(); ++kept) {
    *kept = *record++;
    for (; record != records.end() && record->key == kept->key; ++record)
      kept->state = together(kept->state, record->state);
  }
  records.erase(kept, records.end());
}

RecordTable impact_table(std::span<const ImpactRecord> records) {
  RecordTable table{.name = "contact_impacts", .key_width = 4, .value_width = impact_width};
  for (const auto& [key, state] : records) {
    const SavedKey numbers = saved(key);
    table.keys.insert(table.keys.end(), numbers.begin(), numbers.end());
    table.values.insert(table.values.end(), {state.bank, state.pressed, state.recent, state.most, state.flow});
  }
  return table;
}

std::vector<ImpactRecord> impacts_from(const RecordTable& table) {
  if (table.keys.empty()) return {};
  demand(table.values.size() == impact_width * static_cast<std::size_t>(table.rows()),
         "the table of impacts is complete");
  std::vector<ImpactRecord> records;
  const double* value = table.values.data();
  for (auto key = table.keys.begin(); key != table.keys.end(); key += 4, value += impact_width)
    records.push_back(
        {anchor_key_from({key[0], key[1], key[2], key[3]}), {value[0], value[1], value[2], value[3], value[4]}});
  std::ranges::sort(records, {}, &ImpactRecord::key);
  return records;
}

}  // namespace brunt::contact
