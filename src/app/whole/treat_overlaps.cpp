// SPDX-License-Identifier: Apache-2.0
#include "treat_overlaps.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <iterator>

#include "move_report.hpp"
#include "place_parts.hpp"
#include "placed_beyond.hpp"
#include "scene/text/units.hpp"
#include "setup/accepted_overlaps.hpp"
#include "setup/move_overlaps.hpp"
#include "start_rules.hpp"

namespace brunt::app {
namespace {

bool any_to_place(const setup::InitialGaps& gaps) {
  const auto asks = [](const auto& one) { return one.rule == setup::OverlapRule::place; };
  return std::ranges::any_of(gaps.overlaps, asks) || std::ranges::any_of(gaps.piercings, asks) ||
         std::ranges::any_of(gaps.shared, asks);
}

/// Places parts, and judges anew where they stand then; the list stays that of the mesh as it was. Returns warnings of
/// parts that were moved through what the placement does not see, or far beyond their overlaps.
std::vector<std::string> place(const scene::Input& input, mesh::Mesh& mesh, const setup::StartRules& rules,
                               TreatedOverlaps& treated) {
  const std::vector<Vec3> before = mesh.coordinates;
  PlacedParts placed = place_parts(input, mesh, rules, treated.gaps);
  OverlapReport& report = treated.report;
  report.faults = std::move(placed.faults);
  if (!report.faults.empty()) return {};
  report.notes = std::move(placed.notes);
  treated.gaps = setup::initial_gaps(mesh, rules);
  OverlapReport after = report_overlaps(input, mesh, treated.gaps);
  report.warnings = std::move(after.warnings);
  report.faults = std::move(after.faults);
  if (report.faults.empty() && any_to_place(treated.gaps))
    report.faults.push_back(input.at("contact") + ": invalid initial_overlap: place leaves an overlap: " +
                            (after.list.empty() ? "of parts that move as one body" : after.list.front()) +
                            "; expected parts whose surfaces do not intersect themselves");
  if (!report.faults.empty()) {
    mesh.coordinates = before;
    return {};
  }
  std::vector<std::string> warnings = placed_beyond(input, mesh, before);
  warnings.insert(warnings.end(), placed.warnings.begin(), placed.warnings.end());
  return warnings;
}

}  // namespace

TreatedOverlaps treat_overlaps(const scene::Input& input, mesh::CanonicalMesh& whole) {
  mesh::Mesh& mesh = whole.mesh;
  const setup::StartRules rules = start_rules(input, mesh);
  TreatedOverlaps treated{.gaps = setup::initial_gaps(mesh, rules), .report = {}, .accepted = {}, .recovered = false};
  treated.report = report_overlaps(input, mesh, treated.gaps);
  std::vector<std::string> beyond;
  if (treated.report.faults.empty() && any_to_place(treated.gaps)) beyond = place(input, mesh, rules, treated);
  treated.recovered = !treated.report.warnings.empty();
  treated.report.warnings.insert(treated.report.warnings.end(), beyond.begin(), beyond.end());
  if (!treated.report.faults.empty()) return treated;
  const auto asked = [&](setup::OverlapRule rule) {
    return std::ranges::any_of(treated.gaps.overlaps, [&](const setup::InitialOverlap& o) { return o.rule == rule; });
  };
  std::vector<setup::InitialOverlap> kept;  // or moved
  if (asked(setup::OverlapRule::move)) {
    std::ranges::copy_if(treated.gaps.overlaps, std::back_inserter(kept), &setup::InitialOverlap::is_moved);
    const HeldByScene held = held_nodes(input, mesh);
    const setup::OverlapMoves moved = setup::move_overlaps(mesh, rules, held.nodes, treated.gaps);
    treated.report.faults = report_refused_moves(input, mesh, held.key, moved);
    if (moved.refused()) return treated;
    treated.gaps = setup::initial_gaps(mesh, rules);
    treated.report.notes.push_back(fmt::format("initial overlaps: {} node{} moved, by {} at most", moved.nodes,
                                               moved.nodes == 1 ? "" : "s",
                                               scene::with_length(moved.largest, input.units)));
  }
  if (asked(setup::OverlapRule::offset)) {
    const std::vector<contact::AcceptedOverlap> accepted = setup::accepted_overlaps(treated.gaps.overlaps);
    double largest = 0;
    for (const contact::AcceptedOverlap& overlap : accepted) largest = std::max(largest, overlap.penetration);
    treated.report.notes.push_back(fmt::format("initial overlaps: {} node{} kept as zero gap, {} at most",
                                               accepted.size(), accepted.size() == 1 ? "" : "s",
                                               scene::with_length(largest, input.units)));
  }
  kept.insert(kept.end(), treated.gaps.overlaps.begin(), treated.gaps.overlaps.end());
  treated.accepted = setup::accepted_overlaps(kept);
  return treated;
}

}  // namespace brunt::app
