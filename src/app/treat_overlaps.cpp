// SPDX-License-Identifier: Apache-2.0
#include "treat_overlaps.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <iterator>
#include <limits>
#include <map>

#include "brunt/scene/units.hpp"
#include "move_overlaps.hpp"

namespace brunt::app {
namespace {

bool is_moved(const InitialOverlap& overlap) {
  return overlap.rule == OverlapRule::move;
}

/// Both sides are named; contact uses those of its slaves. A node behind faces of two blocks of a body has the deeper.
/// A node that was moved onto a face keeps nothing itself, but an edge from it to a node beside the face still hangs
/// over the rim: it keeps its overlap there, as edges of named nodes do.
std::vector<contact::AcceptedOverlap> accepted_overlaps(const std::vector<InitialOverlap>& overlaps) {
  constexpr double named = std::numeric_limits<double>::min();
  std::map<std::pair<GlobalIndex, std::int32_t>, contact::AcceptedOverlap> deepest;
  for (const InitialOverlap& overlap : overlaps) {
    if (overlap.rule != OverlapRule::offset && !is_moved(overlap)) continue;
    const double depth = is_moved(overlap) ? named : overlap.depth;
    // the canonical position of a node is its gid
    contact::AcceptedOverlap& kept = deepest[{overlap.node, overlap.other_body}];
    kept = {overlap.node, overlap.other_body, std::max(kept.depth, depth), overlap.body};
  }
  std::vector<contact::AcceptedOverlap> accepted;
  accepted.reserve(deepest.size());
  for (const auto& [key, overlap] : deepest) accepted.push_back(overlap);
  return accepted;
}

}  // namespace

TreatedOverlaps treat_overlaps(const scene::Input& input, mesh::CanonicalMesh& whole) {
  TreatedOverlaps treated{.gaps = initial_gaps(input, whole.mesh), .report = {}, .accepted = {}, .recovered = false};
  treated.report = report_overlaps(input, whole.mesh, treated.gaps);
  treated.recovered = !treated.report.warnings.empty();
  if (!treated.report.faults.empty()) return treated;
  const auto asked = [&](OverlapRule rule) {
    return std::ranges::any_of(treated.gaps.overlaps, [&](const InitialOverlap& o) { return o.rule == rule; });
  };
  std::vector<InitialOverlap> kept;  // or moved
  if (asked(OverlapRule::move)) {
    std::ranges::copy_if(treated.gaps.overlaps, std::back_inserter(kept), is_moved);
    const MoveReport moved = move_overlaps(input, whole, treated.gaps);
    treated.report.faults = moved.faults;
    if (!moved.faults.empty()) return treated;
    treated.gaps = initial_gaps(input, whole.mesh);
    treated.report.notes.push_back(fmt::format("initial overlaps: {} node{} moved, by {} at most", moved.nodes,
                                               moved.nodes == 1 ? "" : "s",
                                               scene::with_length(moved.largest, input.units)));
  }
  if (asked(OverlapRule::offset)) {
    const std::vector<contact::AcceptedOverlap> accepted = accepted_overlaps(treated.gaps.overlaps);
    double largest = 0;
    for (const contact::AcceptedOverlap& overlap : accepted) largest = std::max(largest, overlap.depth);
    treated.report.notes.push_back(fmt::format("initial overlaps: {} node{} keep theirs as zero gap, {} at most",
                                               accepted.size(), accepted.size() == 1 ? "" : "s",
                                               scene::with_length(largest, input.units)));
  }
  kept.insert(kept.end(), treated.gaps.overlaps.begin(), treated.gaps.overlaps.end());
  treated.accepted = accepted_overlaps(kept);
  return treated;
}

}  // namespace brunt::app
