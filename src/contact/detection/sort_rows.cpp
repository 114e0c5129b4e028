// SPDX-License-Identifier: Apache-2.0
// Rows are large: their keys are sorted, and each row moves once.
#include <algorithm>
#include <iterator>
#include <utility>

#include "contact/detection/detection.hpp"

namespace brunt::contact {
namespace {

using Place = RowSortScratch::Place;

bool before(const Place& one, const Place& other) {
  return one.key < other.key;
}

void find_runs(RowSortScratch& scratch) {
  scratch.runs.assign(1, 0);
  for (std::size_t i = 1; i < scratch.places.size(); ++i)
    if (before(scratch.places[i], scratch.places[i - 1])) scratch.runs.push_back(i);
  scratch.runs.push_back(scratch.places.size());
}

/// Of every two runs one.
void merge_runs(RowSortScratch& scratch) {
  std::vector<std::size_t>& runs = scratch.runs;
  const auto at = [&](std::size_t place) { return scratch.places.begin() + static_cast<std::ptrdiff_t>(place); };
  scratch.merged.clear();
  std::size_t kept = 1;
  for (std::size_t r = 0; r + 1 < runs.size(); r += 2) {
    const std::size_t middle = runs[r + 1], end = r + 2 < runs.size() ? runs[r + 2] : middle;
    std::merge(at(runs[r]), at(middle), at(middle), at(end), std::back_inserter(scratch.merged), before);
    runs[kept++] = end;
  }
  runs.resize(kept);
  std::swap(scratch.places, scratch.merged);
}

}  // namespace

void sort_rows(std::vector<Row>& rows, RowSortScratch& scratch) {
  if (std::ranges::is_sorted(rows, {}, &Row::key)) return;  // as they mostly are where no edges cross
  scratch.places.clear();
  for (std::size_t q = 0; q < rows.size(); ++q) scratch.places.push_back({saved(rows[q].key), q});
  find_runs(scratch);
  while (scratch.runs.size() > 2) merge_runs(scratch);
  scratch.rows.clear();
  for (const Place& place : scratch.places) scratch.rows.push_back(rows[place.row]);
  std::swap(rows, scratch.rows);
}

}  // namespace brunt::contact
