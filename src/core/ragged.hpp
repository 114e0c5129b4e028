// SPDX-License-Identifier: Apache-2.0
// Rows of unequal length in two flat arrays: row i is values[offsets[i] .. offsets[i+1]).
#pragma once
#include <cstddef>
#include <span>
#include <vector>

#include "core/types.hpp"

namespace brunt {

template <class T>
struct Ragged {
  std::vector<LocalIndex> offsets{0};  // size rows + 1
  std::vector<T> values;

  [[nodiscard]] LocalIndex rows() const { return static_cast<LocalIndex>(offsets.size()) - 1; }
  [[nodiscard]] std::span<const T> row(LocalIndex i) const {
    return {values.data() + nth(offsets, i),
            static_cast<std::size_t>(offsets[static_cast<std::size_t>(i) + 1] - nth(offsets, i))};
  }
  [[nodiscard]] std::span<T> row(LocalIndex i) {
    return {values.data() + nth(offsets, i),
            static_cast<std::size_t>(offsets[static_cast<std::size_t>(i) + 1] - nth(offsets, i))};
  }
  /// Ends the row of the values appended to `values` since the last call.
  void close_row() { offsets.push_back(static_cast<LocalIndex>(values.size())); }
  void clear() {
    offsets.assign(1, 0);
    values.clear();
  }
};

/// Row c of `columns` lists the rows that contain c, ascending; 0 <= c < column_count.
inline void transpose(const Ragged<LocalIndex>& rows, std::size_t column_count, Ragged<LocalIndex>& columns) {
  std::vector<LocalIndex>& offsets = columns.offsets;
  offsets.assign(column_count + 1, 0);
  for (const LocalIndex c : rows.values) ++offsets[static_cast<std::size_t>(c) + 1];
  for (std::size_t c = 0; c < column_count; ++c) offsets[c + 1] += offsets[c];
  std::vector<LocalIndex> next(offsets.begin(), offsets.end() - 1);
  columns.values.resize(rows.values.size());
  for (LocalIndex r = 0; r < rows.rows(); ++r)
    for (const LocalIndex c : rows.row(r)) nth(columns.values, nth(next, c)++) = r;
}

}  // namespace brunt
