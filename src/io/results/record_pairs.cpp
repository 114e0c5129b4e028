// SPDX-License-Identifier: Apache-2.0
// Pairs records by step, then by time (see the header).
#include "io/results/record_pairs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace brunt::io {
namespace {

bool same_time(double a, double b) {
  return std::abs(a - b) <= 1e-9 * std::max(std::abs(a), std::abs(b));
}

void add_line(std::vector<std::string>& lines, const std::vector<std::size_t>& unpaired, std::span<const Instant> side,
              const std::string& what, char name) {
  constexpr std::size_t most_named = 8;
  if (unpaired.empty()) return;
  if (unpaired.size() == 1) {
    const Instant& instant = side[unpaired.front()];
    lines.push_back(fmt::format("{}: step {} (time {:g}) is only in {}", what, instant.step, instant.time, name));
    return;
  }
  std::string steps;
  for (std::size_t i = 0; i < std::min(unpaired.size(), most_named); ++i)
    steps += fmt::format("{}{}", i ? ", " : "", side[unpaired[i]].step);
  if (unpaired.size() > most_named) steps += fmt::format(", ... ({} in all)", unpaired.size());
  lines.push_back(fmt::format("{}s: steps {} are only in {}", what, steps, name));
}

}  // namespace

RecordPairs pair_records(std::span<const Instant> a, std::span<const Instant> b) {
  RecordPairs pairs;
  std::multimap<GlobalIndex, std::size_t> by_step;
  for (std::size_t j = 0; j < b.size(); ++j) by_step.emplace(b[j].step, j);
  std::vector<std::size_t> left;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const auto found = by_step.find(a[i].step);
    if (found == by_step.end()) {
      left.push_back(i);
      continue;
    }
    pairs.both.emplace_back(i, found->second);
    by_step.erase(found);
  }
  std::multimap<double, std::size_t> by_time;
  for (const auto& [step, j] : by_step) by_time.emplace(b[j].time, j);
  for (const std::size_t i : left) {
    const double time = a[i].time;
    const auto found = by_time.lower_bound(time - 1e-9 * std::abs(time));
    if (found == by_time.end() || !same_time(found->first, time)) {
      pairs.only_a.push_back(i);
      continue;
    }
    pairs.both.emplace_back(i, found->second);
    by_time.erase(found);
  }
  for (const auto& [time, j] : by_time) pairs.only_b.push_back(j);
  std::ranges::sort(pairs.both);
  std::ranges::sort(pairs.only_b);
  return pairs;
}

std::vector<std::string> unpaired_lines(const RecordPairs& pairs, std::span<const Instant> a,
                                        std::span<const Instant> b, const std::string& what) {
  std::vector<std::string> lines;
  if (pairs.both.empty() && !a.empty() && !b.empty())
    lines.push_back(fmt::format("{}s: A and B have none of the same step or time", what));
  add_line(lines, pairs.only_a, a, what, 'A');
  add_line(lines, pairs.only_b, b, what, 'B');
  return lines;
}

}  // namespace brunt::io
