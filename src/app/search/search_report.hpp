// SPDX-License-Identifier: Apache-2.0
// Common parts of searches of all text scenes: distribution over the ranks, times, the result.
#pragma once
#include <chrono>
#include <cstdint>
#include <vector>

#include "app/program/commands.hpp"
#include "comm/rendezvous.hpp"

namespace brunt::app {

/// Entities 0..total-1 of the root in equal blocks.
template <class T>
std::vector<T> deal(const comm::Communicator& ranks, const std::vector<T>& whole, const comm::BlockLayout& layout) {
  std::vector<std::vector<T>> outgoing(static_cast<std::size_t>(ranks.size()));
  for (Rank r = 0; ranks.is_root() && r < ranks.size(); ++r) {
    const auto first = whole.begin() + layout.first(r);
    nth(outgoing, r).assign(first, first + layout.count(r));
  }
  return comm::exchange(ranks, outgoing).values;
}

/// What the ranks told each other of their faces.
struct Traffic {
  GlobalIndex ghosts = 0, messages = 0, bytes = 0;  ///< received, sent, sent: the most of a rank
};

using Clock = std::chrono::steady_clock;
using Seconds = std::chrono::duration<double>;

struct Timing {
  double build = 0, query = 0;  ///< [s]
  std::size_t memory = 0;       ///< [bytes] beside nodes, boxes and pairs
  std::int64_t tests = 0;       ///< of two volumes, of trees

  [[nodiscard]] double total() const { return build + query; }
};

template <class Build, class Query>
Timing timed(const Build& build, const Query& query) {
  const Clock::time_point start = Clock::now();
  build();
  const Clock::time_point built = Clock::now();
  query();
  const Seconds building = built - start, searching = Clock::now() - built;
  return {.build = building.count(), .query = searching.count()};
}

/// In the file's numbers: face and node, or slave facet and master facet.
struct FoundPair {
  GlobalIndex first = 0, second = 0;
  friend auto operator<=>(const FoundPair&, const FoundPair&) = default;
};

/// A search of a scene.
struct SearchResult {
  GlobalIndex nodes = 0, faces = 0;
  std::vector<FoundPair> found;  ///< of this rank
  Timing best;                   ///< of this rank
  Traffic traffic;
};

/// Prints the pairs if they are wanted, then one JSON object. Collective.
void print_result(const comm::Communicator& ranks, const SearchOptions& options, const SearchResult& result);

}  // namespace brunt::app
