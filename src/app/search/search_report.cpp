// SPDX-License-Identifier: Apache-2.0
#include "search_report.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <nlohmann/json.hpp>

#include "io/json_text.hpp"

namespace brunt::app {
namespace {

std::uint64_t pair_hash(std::uint64_t first, std::uint64_t second) {
  std::uint64_t z = (first * (std::uint64_t{1} << 32) + second) * 0x9E3779B97F4A7C15ULL;
  z ^= z >> 29;
  z *= 0xBF58476D1CE4E5B9ULL;
  return z ^ (z >> 32);
}

void print_pairs(const comm::Communicator& ranks, const std::vector<FoundPair>& here) {
  std::vector<FoundPair> all;
  for (const std::vector<std::byte>& bytes : ranks.gather(std::as_bytes(std::span(here)))) {
    const std::size_t before = all.size();
    all.resize(before + bytes.size() / sizeof(FoundPair));
    if (!bytes.empty()) std::memcpy(&all[before], bytes.data(), bytes.size());
  }
  std::ranges::sort(all);
  for (const FoundPair& pair : all) fmt::print("{} {}\n", pair.first, pair.second);
}

}  // namespace

void print_result(const comm::Communicator& ranks, const SearchOptions& options, const SearchResult& result) {
  std::uint64_t hash = 0;
  for (const FoundPair& pair : result.found)
    hash += pair_hash(static_cast<std::uint64_t>(pair.first), static_cast<std::uint64_t>(pair.second));
  std::array<GlobalIndex, 4> sums{static_cast<GlobalIndex>(result.found.size()), std::bit_cast<GlobalIndex>(hash),
                                  static_cast<GlobalIndex>(result.best.memory), result.best.tests};
  ranks.sum(sums);
  if (options.list) print_pairs(ranks, result.found);
  if (!ranks.is_root()) return;
  nlohmann::ordered_json object{{"method", options.method},
                                {"nodes", result.nodes},
                                {"faces", result.faces},
                                {"pairs", sums[0]},
                                {"pairs_hash", fmt::format("{:016x}", std::bit_cast<std::uint64_t>(sums[1]))},
                                {"build_s", result.best.build},
                                {"query_s", result.best.query},
                                {"memory_bytes", sums[2]},
                                {"ranks", ranks.size()},
                                {"most_ghosts", result.traffic.ghosts},
                                {"most_messages", result.traffic.messages},
                                {"most_bytes_sent", result.traffic.bytes}};
  if (options.method == "kdop") object["tests"] = sums[3];
  fmt::print("{}\n", io::json_text(object));
}

}  // namespace brunt::app
