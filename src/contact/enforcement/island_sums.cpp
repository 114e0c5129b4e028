// SPDX-License-Identifier: Apache-2.0
#include "contact/enforcement/island_sums.hpp"

#include <cmath>

#include "contact/enforcement/system.hpp"
#include "core/fixed_sum.hpp"

namespace brunt::contact {
namespace {

/// Digits of the sums, and of the sums of what they leave: 2^22 rows of an island fit in 63 bits.
constexpr int digits = 40;
constexpr std::size_t parts_of_sum = 2;

/// A sum of terms up to a bound as two whole numbers, exact in any order.
struct SplitUnit {
  FixedUnit coarse, fine;
  explicit SplitUnit(double bound) : coarse(bound, digits), fine(std::ldexp(bound, -digits), digits) {}
  void add(double term, std::int64_t* sum) const {
    const std::int64_t units = coarse.of(term);
    sum[0] += units;
    sum[1] += fine.of(term - coarse.value(units));
  }
  [[nodiscard]] double value(const std::int64_t* sum) const { return coarse.value(sum[0]) + fine.value(sum[1]); }
};

}  // namespace

void sum_over_islands(std::span<const double> terms, std::size_t width, const Islands& islands, Exchange& exchange,
                      IslandSums& sums) {
  const std::size_t count = islands.labels.size(), rows = islands.of_row.size();
  sums.bounds.assign(count, 0.0);
  for (std::size_t q = 0; q < rows; ++q)
    if (const LocalIndex island = islands.of_row[q]; island != no_index)
      for (const double term : terms.subspan(width * q, width)) keep_max(nth(sums.bounds, island), std::abs(term));
  exchange.max(sums.bounds);
  sums.parts.assign(parts_of_sum * width * count, 0);
  for (std::size_t q = 0; q < rows; ++q) {
    if (islands.of_row[q] == no_index) continue;
    const auto island = static_cast<std::size_t>(islands.of_row[q]);
    const SplitUnit unit(sums.bounds[island]);
    for (std::size_t t = 0; t < width; ++t)
      unit.add(terms[width * q + t], &sums.parts[parts_of_sum * (width * island + t)]);
  }
  exchange.sum(sums.parts);
  sums.values.resize(width * count);
  for (std::size_t i = 0; i < count; ++i) {
    const SplitUnit unit(sums.bounds[i]);
    for (std::size_t t = 0; t < width; ++t)
      sums.values[width * i + t] = unit.value(&sums.parts[parts_of_sum * (width * i + t)]);
  }
}

}  // namespace brunt::contact
