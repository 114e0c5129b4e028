// SPDX-License-Identifier: Apache-2.0
#include "depth_watch.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "core/cells.hpp"
#include "core/error.hpp"
#include "geometry/box.hpp"
#include "implicit_watch.hpp"
#include "model/alive.hpp"
#include "scene/text/units.hpp"

namespace brunt::app {
namespace {

using geometry::Box;

/// Boxes around the surface nodes of each part, of all ranks. Collective.
std::vector<Box> boxes_of_parts(const Prepared& run, const contact::Surface& surface,
                                const contact::VectorView& position) {
  std::vector<double> most(6 * run.model.blocks.size(), -std::numeric_limits<double>::infinity());
  for (LocalIndex node = 0; node < static_cast<LocalIndex>(surface.gid.size()); ++node) {
    if (!surface.owns(node, run.links.ranks.rank())) continue;
    const Vec3 x = position[nth(surface.model_node, node)];
    for (const std::int32_t block : surface.blocks.row(node))
      for (std::size_t a = 0; a < 3; ++a) {
        double* const at = &most[6 * static_cast<std::size_t>(block) + a];
        at[0] = std::max(at[0], -x[static_cast<Eigen::Index>(a)]);
        at[3] = std::max(at[3], x[static_cast<Eigen::Index>(a)]);
      }
  }
  run.links.ranks.max(most);
  std::vector<Box> boxes;
  for (std::size_t b = 0; b < run.model.blocks.size(); ++b)
    boxes.push_back({-Vec3(&most[6 * b]), Vec3(&most[6 * b + 3])});
  return boxes;
}

/// Once for each rigid body that lies deep behind a wall; known: pairs that are reported. Collective.
std::vector<std::string> warnings_of_walls(const Prepared& run,
                                           std::vector<std::pair<std::int32_t, std::int32_t>>& known) {
  std::vector<std::string> warnings;
  if (!run.implicit || !run.watched) return warnings;
  const std::vector<double> shares = shares_behind_walls(run, false);
  for (std::size_t b = 0; b < shares.size(); ++b) {
    const model::RigidBody& body = run.model.bodies[b];
    const std::pair pair(body.blocks.front(), std::int32_t{no_index});
    if (!(shares[b] > run.input.guards.depth_warning) || std::ranges::find(known, pair) != known.end()) continue;
    known.push_back(pair);
    const bool driven = std::ranges::any_of(body.drive, [](const auto& drive) { return drive.has_value(); });
    warnings.push_back(
        fmt::format("rigid part '{}' lies {:.2g} of an element behind a rigid wall at t = {:g}, step {}: walls hold "
                    "rigid bodies by springs, which yield by what a body travels in some steps{} (reported once; "
                    "max_penetration in summary.json is the largest depth)",
                    body.part, shares[b], run.state.time, static_cast<GlobalIndex>(run.state.step),
                    driven ? " and to a prescribed motion: drive it less far, or use a smaller solver.step"
                           : ": use a smaller solver.step"));
  }
  return warnings;
}

}  // namespace

contact::WatchedSurface watched_surface(const Prepared& run) {
  if (!run.watched) return contact::watched_surface(*run.contact);  // that of an implicit scene has walls alone
  return {run.links.ranks, run.watched->surface, run.watched->pairs, {}, contact::standard_tolerances};
}

std::vector<contact::GhostElement> elements_within_reach(const Prepared& run, const contact::WatchedSurface& watched,
                                                         const contact::VectorView& position) {
  const std::vector<Box> parts = boxes_of_parts(run, watched.surface, position);
  const auto meets = [&](std::size_t one, std::size_t other) {
    return watched.pairs.at(static_cast<std::int32_t>(one), static_cast<std::int32_t>(other)).rule !=
           contact::PairRule::apart;
  };
  std::vector<GlobalIndex> at_surface;
  for (const contact::SurfaceFace& face : watched.surface.faces) at_surface.push_back(cells::element_of_key(face.key));
  std::vector<contact::GhostElement> elements;
  for (std::size_t b = 0; b < run.model.blocks.size(); ++b) {
    const model::ElementBlock& block = run.model.blocks[b];
    if (cells::of(block.shape).dimension != 3) continue;
    for (LocalIndex e = 0; e < block.count; ++e) {
      if (!model::lives(run.state, b, e)) continue;
      contact::GhostElement element{
          .gid = nth(block.gid, e), .corner_count = block.corners(), .block = static_cast<std::int32_t>(b)};
      element.nodes.fill(no_index);
      Box box;
      for (int c = 0; c < block.corners(); ++c) {
        const LocalIndex node = block.corner_node(e, c);
        const Vec3 x = position[node];
        nth(element.nodes, c) = nth(run.model.mesh.node_gid, node);
        nth(element.corner, c) = {x[0], x[1], x[2]};
        geometry::extend(box, x);
      }
      const auto in_part = [&](std::size_t other) {
        return other != b && meets(other, b) && geometry::overlaps(parts[other], box);
      };
      bool near = meets(b, b) && std::ranges::binary_search(at_surface, element.gid);
      for (std::size_t other = 0; other < parts.size() && !near; ++other) near = in_part(other);
      if (!near) continue;
      element.capture = contact::PlainBox(box);
      elements.push_back(element);
    }
  }
  return elements;
}

std::string text_of(const Prepared& run, const contact::DeepNode& deep) {
  const auto part = [&](std::int32_t block) { return nth(run.model.blocks, block).part; };
  const model::Model& model = run.model;
  const auto node = std::ranges::find(model.mesh.node_gid, deep.node);
  const GlobalIndex id = run.links.ranks.max(node == model.mesh.node_gid.end()
                                                 ? GlobalIndex{-1}
                                                 : nth(model.mesh.node_id, node - model.mesh.node_gid.begin()));
  return fmt::format("{} {} of part '{}' {} {} deep in part '{}' at t = {:g}, step {}, {:.2g} of an element there",
                     deep.on_edge ? "an edge at node" : "node", id, part(deep.node_block), "lies",
                     scene::with_length(deep.depth, run.input.units), part(deep.block), run.state.time,
                     static_cast<GlobalIndex>(run.state.step), deep.share);
}

bool DepthWatch::is_due(const Prepared& run) const {
  if (run.implicit) return run.watched != nullptr;  // a row of its history is far from the last
  return run.contact && run.contact->ledger.statistics.searches >= lists_seen_ + lists_between_looks;
}

std::vector<std::string> DepthWatch::look(const Prepared& run) {
  std::vector<std::string> warnings = warnings_of_walls(run, reported_);
  if (run.implicit ? run.watched == nullptr || run.model.touching.mortar.empty()
                   : !run.contact || !run.contact->derived.bodies)
    return warnings;
  if (run.contact) lists_seen_ = run.contact->ledger.statistics.searches;
  const contact::VectorView position{run.state.nodes.empty() ? nullptr : run.state.nodes.front().x,
                                     sizeof(model::NodeLine) / sizeof(double)};
  const contact::WatchedSurface watched = watched_surface(run);
  const contact::DeepNodes found = contact::find_deep_nodes(
      watched, position, elements_within_reach(run, watched, position), least_depth(run.input.guards));
  const contact::DeepNode& worst = found.worst;
  if (worst.share > deepest_.share) deepest_ = worst;
  const scene::Guards& limits = run.input.guards;
  if (!(worst.share > limits.depth_warning)) return warnings;
  const bool begins_inside =
      run.overlaps.recovered || (run.contact && !run.contact->derived.detection.accepted.empty());
  const bool lost = worst.share >= but_for_rounding * limits.depth_stop && !begins_inside &&
                    !(run.contact && run.contact->settings.erodes);
  const std::pair pair(worst.node_block, worst.block);
  const bool known = std::ranges::find(reported_, pair) != reported_.end();
  if (known && !lost) return warnings;
  const std::string text = text_of(run, worst);
  if (lost)
    throw GuardError(fmt::format("contact has lost {}: {}; use {}", worst.on_edge ? "edges" : "nodes", text,
                                 run.implicit ? "smaller elements there, the finer side as slave, or a smaller "
                                                "solver.step"
                                              : "smaller elements there, a smaller step, element: hex8_full, or "
                                                "passes: two"));
  reported_.push_back(pair);
  warnings.push_back(fmt::format(
      "contact leaves penetration: {}{}; {}: use smaller elements there (reported once for each pair of parts; "
      "deepest_penetration in summary.json is the largest)",
      text,
      found.count > 1 ? fmt::format(" ({} nodes and edges are deeper than {:g})", found.count, least_depth(limits))
                      : "",
      run.implicit ? "mortar contact holds mean gaps over facets of the slave, not nodes, so a coarse slave lets the "
                     "other side in"
                   : "contact does not hold edges between nodes, nor nodes that passed a folded or a very coarse "
                     "element"));
  return warnings;
}

}  // namespace brunt::app
