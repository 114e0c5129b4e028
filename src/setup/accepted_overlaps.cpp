// SPDX-License-Identifier: Apache-2.0
#include "setup/accepted_overlaps.hpp"

#include <algorithm>
#include <limits>
#include <map>
#include <utility>

namespace brunt::setup {

/// Both sides are listed; contact uses those of its slaves. A node behind faces of two blocks of a body keeps the
/// larger depth. A node that was moved onto a face has no overlap itself, but an edge from it to a node beside the face
/// still overlaps at the face's boundary: it keeps its overlap there, as edges of listed nodes do.
std::vector<contact::AcceptedOverlap> accepted_overlaps(const std::vector<InitialOverlap>& overlaps) {
  constexpr double named = std::numeric_limits<double>::min();
  std::map<std::pair<GlobalIndex, std::int32_t>, contact::AcceptedOverlap> deepest;
  for (const InitialOverlap& overlap : overlaps) {
    if (overlap.rule != OverlapRule::offset && !overlap.is_moved()) continue;
    const double penetration = overlap.is_moved() ? named : overlap.penetration;
    // the canonical position of a node is its gid
    contact::AcceptedOverlap& kept = deepest[{overlap.node, overlap.other_body}];
    kept = {overlap.node, overlap.other_body, std::max(kept.penetration, penetration), overlap.body};
  }
  std::vector<contact::AcceptedOverlap> accepted;
  accepted.reserve(deepest.size());
  for (const auto& [key, overlap] : deepest) accepted.push_back(overlap);
  return accepted;
}

}  // namespace brunt::setup
