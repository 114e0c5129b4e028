// SPDX-License-Identifier: Apache-2.0
// Pairs the records of two results.
#pragma once
#include <cstddef>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "core/types.hpp"

namespace brunt::io {

/// When a record was taken.
struct Instant {
  GlobalIndex step = 0;
  double time = 0;
};

/// Positions in A and B, in A's order.
struct RecordPairs {
  std::vector<std::pair<std::size_t, std::size_t>> both;
  std::vector<std::size_t> only_a, only_b;
};

/// Records of the same step are paired; of the remaining ones, those whose times are equal to 1e-9 (one run may take
/// twice as many steps as the other).
[[nodiscard]] RecordPairs pair_records(std::span<const Instant> a, std::span<const Instant> b);

/// "record: step 10 (time 2.5) is only in A", "records: steps 10, 20, 30, ... (17 in all) are only in A"; empty if all
/// are paired. `what`: "record" or "history row".
[[nodiscard]] std::vector<std::string> unpaired_lines(const RecordPairs& pairs, std::span<const Instant> a,
                                                      std::span<const Instant> b, const std::string& what);

}  // namespace brunt::io
