// SPDX-License-Identifier: Apache-2.0
// Differences of tables, every rank looking at its own rows (see the header).
#include "compare_tables.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "comm/rendezvous.hpp"
#include "core/error.hpp"

namespace brunt::io {

double difference_of(double a, double b) {
  if (a == b) return 0;
  const double difference = std::abs(a - b);
  return std::isnan(difference) ? std::numeric_limits<double>::infinity() : difference;
}

namespace {

LargestDifference of_rows(std::span<const double> a, std::span<const double> b, GlobalIndex first, int width) {
  LargestDifference largest;
  for (std::size_t i = 0; i < a.size(); ++i) {
    for (const double value : {a[i], b[i]})
      if (std::isfinite(value)) largest.magnitude = std::max(largest.magnitude, std::abs(value));
    const double difference = difference_of(a[i], b[i]);
    if (difference > largest.difference) {
      largest.difference = difference;
      largest.row = first + static_cast<GlobalIndex>(i) / width;
      largest.component = static_cast<int>(static_cast<GlobalIndex>(i) % width);
    }
  }
  return largest;
}

// Ranks hold ascending rows, so the lowest rank with the largest difference has the first place.
LargestDifference over_ranks(const comm::Communicator& ranks, const LargestDifference& mine) {
  const std::vector<double> differences = ranks.gather_all(mine.difference);
  const std::vector<double> rows = ranks.gather_all(static_cast<double>(mine.row));
  const std::vector<double> components = ranks.gather_all(static_cast<double>(mine.component));
  const auto first = std::max_element(differences.begin(), differences.end());
  const auto rank = static_cast<std::size_t>(first - differences.begin());
  return {*first, ranks.max(mine.magnitude), std::llround(rows[rank]), static_cast<int>(components[rank])};
}

}  // namespace

LargestDifference largest_difference(const Hdf5File& a, const std::string& name_a, const Hdf5File& b,
                                     const std::string& name_b) {
  const Hdf5File::Extent extent = a.extent(name_a);
  const Hdf5File::Extent other = b.extent(name_b);
  demand(extent.rows == other.rows && extent.width == other.width, "tables of equal extent are compared");
  const comm::BlockLayout layout{extent.rows, a.ranks().size()};
  const Rank rank = a.ranks().rank();
  const GlobalIndex first = layout.first(rank);
  std::vector<double> in_a(static_cast<std::size_t>(layout.count(rank)) * static_cast<std::size_t>(extent.width));
  std::vector<double> in_b(in_a.size());
  a.read(name_a, first, std::span<double>(in_a));
  b.read(name_b, first, std::span<double>(in_b));
  return over_ranks(a.ranks(), of_rows(in_a, in_b, first, extent.width));
}

bool FieldTally::take(double difference, double magnitude, double time) {
  magnitude_ = std::max(magnitude_, magnitude);
  if (difference <= result_.absolute) return false;
  result_.absolute = difference;
  result_.time = time;
  return true;
}

FieldDifference FieldTally::finish(double natural_scale) const {
  FieldDifference result = result_;
  const double scale = std::max(magnitude_, natural_scale);
  if (result.absolute > 0)
    result.relative = scale > 0 ? result.absolute / scale : std::numeric_limits<double>::infinity();
  return result;
}

}  // namespace brunt::io
