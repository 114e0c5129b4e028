// SPDX-License-Identifier: Apache-2.0
#include "treat_overlaps.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <map>

#include "move_overlaps.hpp"

namespace brunt::app {
namespace {

/// Both sides are named; contact uses those of its slaves. A node behind faces of two blocks of a body has the deeper.
std::vector<contact::AcceptedOverlap> accepted_overlaps(const InitialGaps& gaps) {
  std::map<std::pair<GlobalIndex, std::int32_t>, contact::AcceptedOverlap> deepest;
  for (const InitialOverlap& overlap : gaps.overlaps) {
    if (overlap.rule != OverlapRule::offset) continue;
    // the canonical position of a node is its gid
    contact::AcceptedOverlap& kept = deepest[{overlap.node, overlap.other_body}];
    kept = {overlap.node, overlap.other_body, std::max(kept.depth, overlap.depth), overlap.body};
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
  if (asked(OverlapRule::move)) {
    const MoveReport moved = move_overlaps(input, whole, treated.gaps);
    treated.report.faults = moved.faults;
    if (!moved.faults.empty()) return treated;
    treated.gaps = initial_gaps(input, whole.mesh);
    treated.report.notes.push_back(fmt::format("initial overlaps: {} node{} moved, by {:.4g} at most", moved.nodes,
                                               moved.nodes == 1 ? "" : "s", moved.largest));
  }
  if (asked(OverlapRule::offset)) {
    treated.accepted = accepted_overlaps(treated.gaps);
    double largest = 0;
    for (const contact::AcceptedOverlap& overlap : treated.accepted) largest = std::max(largest, overlap.depth);
    treated.report.notes.push_back(fmt::format("initial overlaps: {} node{} keep theirs as zero gap, {:.4g} at most",
                                               treated.accepted.size(), treated.accepted.size() == 1 ? "" : "s",
                                               largest));
  }
  return treated;
}

}  // namespace brunt::app
