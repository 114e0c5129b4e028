// SPDX-License-Identifier: Apache-2.0
#include "contact/deep_nodes.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>
#include <span>
#include <utility>

#include "contact/search/box_overlaps.hpp"
#include "core/cells.hpp"
#include "depth_along.hpp"
#include "geometry/segment_in_cell.hpp"

namespace brunt::contact {
namespace {

using geometry::Box;
using geometry::Segment;
using geometry::Stretch;

/// What of the probe is in the element.
Stretch part_in(const GhostElement& element, const Segment& probe) {
  std::array<Vec3, cells::most_corners> corners;
  const auto count = static_cast<std::size_t>(element.corner_count);
  for (std::size_t i = 0; i < count; ++i) corners[i] = Vec3(element.corner[i].data());
  return geometry::part_in_cell(probe, {corners.data(), count});
}

class Look {
 public:
  Look(const WatchedSurface& watched, const VectorView& position) : watched_(watched), position_(position) {
    list_probes();
  }

  /// Finds what of each probe is in elements.
  void find_inside(std::vector<GhostElement> elements);
  /// The depth of what is inside.
  void measure();
  [[nodiscard]] DeepNodes result(double above) const;

 private:
  /// A node in an element, or what of an edge is in it.
  struct Inside {
    std::size_t probe = 0;
    GlobalIndex element = 0;
    std::int32_t block = 0;
    Stretch part{};
    double chord = 0;  ///< what of the edge is in this block [length]
    double depth = 0, share = 0;
  };
  /// Of equally deep ones a node is named before the edge that ends there, then the lowest node.
  [[nodiscard]] std::pair<bool, std::array<GlobalIndex, 2>> name_of(const Inside& inside) const {
    return {probe_of(inside).on_edge, probe_of(inside).ends};
  }
  void list_probes();
  [[nodiscard]] const Probe& probe_of(const Inside& inside) const { return probes_[inside.probe]; }
  /// What is inside; of a node a segment without length.
  [[nodiscard]] Segment part_of(const Inside& inside) const {
    const Segment& all = probe_of(inside).at;
    const auto at = [&](double place) -> Vec3 { return (1 - place) * all.start + place * all.end; };
    return {at(inside.part.first), at(inside.part.last)};
  }
  [[nodiscard]] Vec3 at(LocalIndex surface_node) const {
    return position_[nth(watched_.surface.model_node, surface_node)];
  }
  [[nodiscard]] bool may_meet(const Probe& probe, std::int32_t block) const {
    const PairTable& pairs = watched_.pairs;
    return std::ranges::any_of(probe.blocks, [&](std::int32_t own) {
      const PairSpecification& pair = pairs.at(own, block);
      return pair.rule != PairRule::apart && pair.tied == Tied::no;
    });
  }
  void keep_lowest_of_nodes();
  void sum_chords();
  [[nodiscard]] std::vector<WatchedSide> own_sides() const;

  const WatchedSurface& watched_;
  const VectorView& position_;
  std::vector<Probe> probes_;
  std::vector<Inside> inside_;  ///< by probe and element
};

void Look::list_probes() {
  const Surface& surface = watched_.surface;
  for (LocalIndex node = 0; node < static_cast<LocalIndex>(surface.gid.size()); ++node) {
    const auto i = static_cast<std::size_t>(node);
    if (!surface.owns(node, watched_.ranks.rank()) || surface.blocks.row(node).empty()) continue;
    probes_.push_back({.at = {at(node), at(node)},
                       .ends = {surface.gid[i], surface.gid[i]},
                       .blocks = surface.blocks.row(node),
                       .around = surface.neighbours.row(node)});
  }
  for (const SurfaceEdge& edge : surface.edges) {
    if (edge.kind != EdgeKind::sharp) continue;
    probes_.push_back({.at = {at(edge.nodes[0]), at(edge.nodes[1])},
                       .ends = {nth(surface.gid, edge.nodes[0]), nth(surface.gid, edge.nodes[1])},
                       .blocks = std::span(&edge.block, 1),
                       .around = edge.elements,
                       .on_edge = true});
  }
}

void Look::find_inside(std::vector<GhostElement> elements) {
  std::vector<Box> wanted, boxes;
  for (const Probe& probe : probes_) wanted.push_back(probe.box());
  const double finest = 2 * watched_.surface.mean_edge;
  const std::vector<GhostElement> ghosts =
      ghost(watched_.ranks, std::span<const GhostElement>(elements), wanted, finest);
  elements.insert(elements.end(), ghosts.begin(), ghosts.end());
  for (const GhostElement& element : elements) boxes.push_back(element.capture.box());
  OverlapScratch scratch;
  for_each_overlap(wanted, boxes, scratch, [&](LocalIndex p, LocalIndex e) {
    const Probe& probe = nth(probes_, p);
    const GhostElement& element = nth(elements, e);
    if (!may_meet(probe, element.block) || touches(probe, element.nodes)) return;
    const Stretch part = part_in(element, probe.at);
    if (part.is_empty() || (probe.on_edge && part.length() == 0)) return;
    inside_.push_back(
        {.probe = static_cast<std::size_t>(p), .element = element.gid, .block = element.block, .part = part});
  });
  std::ranges::sort(inside_, {}, [](const Inside& inside) { return std::pair(inside.probe, inside.element); });
  keep_lowest_of_nodes();
  sum_chords();
}

/// A node on the face between two elements is in both.
void Look::keep_lowest_of_nodes() {
  const auto of_same_node = [&](const Inside& a, const Inside& b) {
    return a.probe == b.probe && !probe_of(a).on_edge;
  };
  inside_.erase(std::unique(inside_.begin(), inside_.end(), of_same_node), inside_.end());
}

void Look::sum_chords() {
  for (Inside& inside : inside_) {
    const Probe& probe = probe_of(inside);
    const double length = (probe.at.end - probe.at.start).norm();
    const auto last = std::ranges::upper_bound(inside_, inside.probe, {}, &Inside::probe);
    for (auto other = std::ranges::lower_bound(inside_, inside.probe, {}, &Inside::probe); other != last; ++other)
      if (other->block == inside.block) inside.chord += other->part.length() * length;
  }
}

std::vector<WatchedSide> Look::own_sides() const {
  std::vector<WatchedSide> sides;
  for (const SurfaceFace& face : watched_.surface.faces) {
    if (watched_.thickness.size() > static_cast<std::size_t>(face.block) && nth(watched_.thickness, face.block) > 0)
      continue;
    WatchedSide side{.key = face.key, .element = face.element, .corner_count = face.corner_count};
    side.element_depth = face.element_depth;
    side.gid.fill(no_index);
    Box box;
    for (std::size_t i = 0; i < side.count(); ++i) {
      const Vec3 x = at(face.nodes[i]);
      side.corner[i] = {x[0], x[1], x[2]};
      side.gid[i] = nth(watched_.surface.gid, face.nodes[i]);
      geometry::extend(box, x);
    }
    side.capture = PlainBox(geometry::grown(box, 2 * face.element_depth));
    sides.push_back(side);
  }
  return sides;
}

void Look::measure() {
  if (!watched_.ranks.any(!inside_.empty())) return;
  std::vector<Box> wanted, boxes;
  for (const Inside& inside : inside_) {
    const Segment part = part_of(inside);
    wanted.push_back(geometry::bounding_box(std::array{part.start, part.end}));
  }
  std::vector<WatchedSide> sides = own_sides();
  const std::vector<WatchedSide> ghosts =
      ghost(watched_.ranks, std::span<const WatchedSide>(sides), wanted, 2 * watched_.surface.mean_edge);
  sides.insert(sides.end(), ghosts.begin(), ghosts.end());
  std::ranges::sort(sides, {}, &WatchedSide::key);
  for (const WatchedSide& side : sides) boxes.push_back(side.capture.box());
  std::vector<std::vector<LocalIndex>> near(inside_.size());
  OverlapScratch scratch;
  for_each_overlap(wanted, boxes, scratch, [&](LocalIndex k, LocalIndex s) { nth(near, k).push_back(s); });
  for (std::size_t k = 0; k < inside_.size(); ++k) {
    Inside& inside = inside_[k];
    std::ranges::sort(near[k]);
    const DepthAlong along(probe_of(inside), inside.chord, sides, near[k], watched_);
    const Depth deepest = along.deepest(part_of(inside));
    inside.depth = deepest.depth;
    inside.share = deepest.depth / deepest.of_element;
  }
}

DeepNodes Look::result(double above) const {
  const comm::Communicator& ranks = watched_.ranks;
  DeepNodes all;
  all.shares.assign(probes_.size(), 0.0);
  for (const Inside& inside : inside_) all.shares[inside.probe] = std::max(all.shares[inside.probe], inside.share);
  const Inside* worst = nullptr;
  std::size_t last = probes_.size();
  for (const Inside& inside : inside_) {
    if (inside.share > above && inside.probe != last) {
      ++all.count;
      last = inside.probe;
    }
    const bool is_equal = worst != nullptr && inside.share == worst->share;
    if (worst == nullptr || inside.share > worst->share || (is_equal && name_of(inside) < name_of(*worst)))
      worst = &inside;
  }
  all.count = ranks.sum(all.count);
  const double most = ranks.max(worst != nullptr ? worst->share : 0.0);
  if (!(most > 0)) return all;
  const bool may_be_mine = worst != nullptr && worst->share == most;
  const double infinity = std::numeric_limits<double>::infinity();
  const bool on_edge = ranks.min(may_be_mine && !probe_of(*worst).on_edge ? 0.0 : 1.0) > 0;
  const bool is_mine = may_be_mine && probe_of(*worst).on_edge == on_edge;
  const double node = ranks.min(is_mine ? static_cast<double>(probe_of(*worst).ends[0]) : infinity);
  std::array<double, 3> words;
  words.fill(-infinity);
  if (is_mine && static_cast<double>(probe_of(*worst).ends[0]) == node)
    words = {static_cast<double>(probe_of(*worst).blocks.front()), static_cast<double>(worst->block), worst->depth};
  ranks.max(words);
  all.worst = {.node = static_cast<GlobalIndex>(node),
               .node_block = static_cast<std::int32_t>(words[0]),
               .block = static_cast<std::int32_t>(words[1]),
               .depth = words[2],
               .share = most,
               .on_edge = on_edge};
  return all;
}

}  // namespace

WatchedSurface watched_surface(const Contact& contact) {
  return {contact.ranks, contact.surface, contact.settings.specification.pairs, contact.settings.blocks.thickness,
          *contact.derived.detection.tolerances};
}

DeepNodes find_deep_nodes(const WatchedSurface& watched, const VectorView& position,
                          const std::vector<GhostElement>& elements, double above) {
  Look look(watched, position);
  look.find_inside(elements);
  look.measure();
  return look.result(above);
}

}  // namespace brunt::contact
