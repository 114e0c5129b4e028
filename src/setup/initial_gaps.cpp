// SPDX-License-Identifier: Apache-2.0
#include "setup/initial_gaps.hpp"

#include <algorithm>
#include <limits>

#include "contact/data/tolerances.hpp"
#include "contact/detection/encounter.hpp"
#include "setup/piercings.hpp"
#include "setup/shared_space.hpp"
#include "setup/slave_choice.hpp"

namespace brunt::setup {
namespace {

/// Depth limit of detection behind a face.
double reach_behind(const SolidFace& face, const contact::Tolerances& tolerances) {
  return tolerances.max_penetration(face.size, face.element_depth);
}

class Survey {
 public:
  Survey(const mesh::Mesh& mesh, const StartRules& rules)
      : mesh_(mesh), rules_(rules), solids_(solids_of(mesh)), body_(body_of_nodes(mesh)), around_(mesh) {
    for (std::size_t a = 0; a < solids_.size(); ++a)
      for (std::size_t b = 0; b <= a; ++b)
        if (const auto rule = rule_of(a, b)) compare(a, b, *rule);
    forgive_masters();
    std::ranges::sort(gaps.overlaps, [](const InitialOverlap& p, const InitialOverlap& q) {
      return p.penetration != q.penetration ? p.penetration > q.penetration : p.node < q.node;
    });
  }

  InitialGaps gaps;

 private:
  [[nodiscard]] const contact::Tolerances& tolerances() const { return *rules_.contact.tolerances; }
  [[nodiscard]] std::optional<OverlapRule> rule_of(std::size_t a, std::size_t b) const {
    if (solids_[a].faces.empty() || solids_[b].faces.empty()) return std::nullopt;
    return rules_.overlap_of(a, b);
  }

  void compare(std::size_t a, std::size_t b, OverlapRule rule) {
    const std::size_t known = gaps.overlaps.size() + gaps.piercings.size();
    std::vector<char> inside(mesh_.coordinates.size(), 0);
    compare_nodes(a, b, rule, inside);
    if (a == b) return;
    compare_nodes(b, a, rule, inside);
    find_piercings(a, b, rule, inside);
    find_piercings(b, a, rule, inside);
    if (gaps.overlaps.size() + gaps.piercings.size() == known) find_shared_space(a, b, rule);
  }

  /// Only if no overlap of nodes or edges was found.
  void find_shared_space(std::size_t a, std::size_t b, OverlapRule rule) {
    if (body_of(solids_[a]) == body_of(solids_[b]) || !geometry::overlaps(solids_[a].box, solids_[b].box)) return;
    for (const auto& [one, other] : {std::pair(a, b), std::pair(b, a)}) {
      const mesh::Block& block = mesh_.blocks[one];
      const ElementsInside inside = elements_inside(mesh_, block, mesh_.blocks[other], tolerances());
      if (inside.count == 0) continue;
      gaps.shared.push_back({one, other, inside.count, nth(block.element_id, inside.first), rule});
      return;
    }
  }

  void compare_nodes(std::size_t a, std::size_t b, OverlapRule rule, std::vector<char>& inside) {
    constexpr std::size_t most_examined = 1000;  // upper limit of nodes so deep that each is tested against all faces
    const Solid& solid = solids_[b];
    const bool one_body = std::ranges::any_of(
        bodies_of(solids_[a]), [&](std::int32_t body) { return std::ranges::binary_search(bodies_of(solid), body); });
    const Comparison compared(mesh_, solids_[a], solid, mesh_.blocks[b], one_body ? &around_ : nullptr, tolerances());
    std::size_t examined = 0;
    for (std::size_t i = 0; i < compared.size(); ++i) {
      const LocalIndex node = compared.node(i);
      if (!compared.overlaps(i)) {
        if (!one_body) keep_gap(a, b, compared.touches(i) ? 0.0 : compared.distance(i));
        continue;
      }
      std::optional<Behind> behind = compared.behind_near(i);
      if (!behind && examined++ < most_examined) behind = compared.behind_any(i);
      if (behind && behind->penetration < 0) {
        if (!one_body) keep_gap(a, b, -behind->penetration);
        continue;
      }
      nth(inside, node) = 1;
      InitialOverlap overlap{.node = node,
                             .block = a,
                             .other_block = b,
                             .body = nth(body_, node),
                             .other_body = behind ? body_of(solid.faces[behind->face]) : body_of(solid),
                             .rule = rule};
      if (behind) {
        const SolidFace& face = solid.faces[behind->face];
        overlap.penetration = behind->penetration;
        overlap.face = face.nodes;
      }
      overlap.too_deep = !behind || behind->penetration > reach_behind(solid.faces[behind->face], tolerances());
      gaps.overlaps.push_back(overlap);
    }
  }

  void find_piercings(std::size_t a, std::size_t b, OverlapRule rule, const std::vector<char>& inside) {
    if (body_of(solids_[a]) == body_of(solids_[b])) return;
    const std::vector<PiercingEdge> edges = piercing_edges(mesh_, solids_[a], solids_[b], inside, tolerances());
    if (edges.empty()) return;
    gaps.piercings.push_back({a, b, edges.size(), edges[0].edge, solids_[b].faces[edges[0].face].nodes, rule});
  }

  void keep_gap(std::size_t block, std::size_t other_block, double gap) {
    if (gap == std::numeric_limits<double>::infinity() || (gaps.smallest >= 0 && gap >= gaps.smallest)) return;
    gaps.smallest = gap;
    gaps.block = block;
    gaps.other_block = other_block;
  }

  /// In one pass contact does not search nodes of the master: their depth is irrelevant.
  void forgive_masters() {
    if (std::ranges::none_of(gaps.overlaps, &InitialOverlap::too_deep)) return;
    const SlaveChoice choice(mesh_, rules_);
    for (InitialOverlap& o : gaps.overlaps)
      o.too_deep = o.too_deep && choice.is_held_off(o.block, o.body, o.other_block, o.other_body);
  }

  [[nodiscard]] std::int32_t body_of(const Solid& solid) const { return nth(body_, solid.surface_nodes.front()); }
  [[nodiscard]] std::int32_t body_of(const SolidFace& face) const { return nth(body_, face.nodes[0]); }
  /// Ascending.
  [[nodiscard]] std::vector<std::int32_t> bodies_of(const Solid& solid) const {
    std::vector<std::int32_t> bodies;
    for (const LocalIndex node : solid.surface_nodes) bodies.push_back(nth(body_, node));
    std::ranges::sort(bodies);
    bodies.erase(std::unique(bodies.begin(), bodies.end()), bodies.end());
    return bodies;
  }

  const mesh::Mesh& mesh_;
  const StartRules& rules_;
  std::vector<Solid> solids_;
  std::vector<std::int32_t> body_;
  NodesAround around_;
};

}  // namespace

InitialGaps initial_gaps(const mesh::Mesh& mesh, const StartRules& rules) {
  if (std::ranges::none_of(rules.overlap, [](const auto& rule) { return rule.has_value(); })) return {};
  return Survey(mesh, rules).gaps;
}

}  // namespace brunt::setup
