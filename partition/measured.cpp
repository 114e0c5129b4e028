// SPDX-License-Identifier: Apache-2.0
#include "partition/measured.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

#include "core/error.hpp"

namespace brunt::partition {
namespace {

/// Time of each element: that of its rank, distributed in proportion to `amount`. Zero if the rank has no amount.
std::vector<double> shares(std::span<const double> seconds, std::span<const Rank> rank,
                           std::span<const double> amount) {
  std::vector<double> whole(seconds.size(), 0.0), share(rank.size(), 0.0);
  for (std::size_t e = 0; e < rank.size(); ++e) nth(whole, rank[e]) += amount[e];
  for (std::size_t e = 0; e < rank.size(); ++e) {
    const auto r = static_cast<std::size_t>(rank[e]);
    if (whole[r] > 0) share[e] = seconds[r] * amount[e] / whole[r];
  }
  return share;
}

double sum(std::span<const double> values) {
  return std::accumulate(values.begin(), values.end(), 0.0);
}

/// As integers whose sum does not overflow in the partitioner.
std::vector<std::int32_t> whole_numbers(const std::vector<double>& times) {
  constexpr double mean_weight = 1000, largest_sum = 1 << 29;
  const auto some = static_cast<double>(std::ranges::count_if(times, [](double t) { return t > 0; }));
  std::vector<std::int32_t> weights(times.size(), 0);
  if (some == 0) return weights;
  const double scale = std::min(mean_weight * some, largest_sum) / sum(times);
  for (std::size_t e = 0; e < times.size(); ++e)
    if (times[e] > 0) weights[e] = std::max(1, static_cast<std::int32_t>(std::lround(times[e] * scale)));
  return weights;
}

}  // namespace

Weights weigh(const Weights& usual, const Measured& measured) {
  const std::size_t elements = usual.cost.size();
  demand(measured.rank.size() == elements && measured.pairs.size() == elements, "each element was measured");
  demand(measured.element_seconds.size() == measured.contact_seconds.size(), "each rank has two times");
  Weights weights = usual;
  const std::vector<double> cost = shares(measured.element_seconds, measured.rank, usual.cost);
  if (const double mean = sum(cost) / static_cast<double>(elements);
      std::ranges::all_of(cost, [](double c) { return c > 0; }))
    std::ranges::transform(cost, weights.cost.begin(), [mean](double c) { return c / mean; });
  weights.contact_faces = whole_numbers(shares(measured.contact_seconds, measured.rank, measured.pairs));
  return weights;
}

}  // namespace brunt::partition
