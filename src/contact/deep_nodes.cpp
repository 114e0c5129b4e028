// SPDX-License-Identifier: Apache-2.0
#include "brunt/contact/deep_nodes.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>
#include <span>
#include <utility>

#include "brunt/contact/data/tolerances.hpp"
#include "brunt/contact/detection/cones.hpp"
#include "brunt/contact/search/box_overlaps.hpp"
#include "brunt/contact/search/search.hpp"
#include "brunt/geometry/closest_point.hpp"
#include "brunt/geometry/segment_in_cell.hpp"

namespace brunt::contact {
namespace {

using geometry::Box;
using geometry::Segment;
using geometry::Stretch;

/// What may lie in an element: a node, as a segment without length, or an edge.
struct Probe {
  Segment at{};
  std::array<GlobalIndex, 2> ends{};  ///< gids, a node's twice
  std::span<const std::int32_t> blocks{};
  std::span<const GlobalIndex> around{};  ///< nodes of its elements
  bool on_edge = false;

  [[nodiscard]] Box box() const { return geometry::bounding_box(std::array{at.start, at.end}); }
};

struct GhostSide {
  GlobalIndex key = 0;
  std::array<std::array<double, 3>, 4> corner{};
  std::array<GlobalIndex, 4> gid{};
  std::array<GlobalIndex, 8> element{};
  std::int32_t corner_count = 4;
  double element_depth = 0;
  PlainBox capture{};

  [[nodiscard]] std::size_t count() const { return static_cast<std::size_t>(corner_count); }
  [[nodiscard]] std::array<Vec3, 4> corners() const {
    std::array<Vec3, 4> at;
    for (std::size_t i = 0; i < count(); ++i) at[i] = Vec3(corner[i].data());
    return at;
  }
  /// Unit, outward; of a warped face the mean.
  [[nodiscard]] Vec3 normal() const {
    const std::array<Vec3, 4> at = corners();
    return geometry::area_vector({at.data(), count()}).normalized();
  }
  friend bool operator<(const GhostSide& a, const GhostSide& b) { return a.key < b.key; }
};

/// What of the probe is in the element.
Stretch part_in(const GhostElement& element, const Segment& probe) {
  std::array<Vec3, 8> corners;
  const auto count = static_cast<std::size_t>(element.corner_count);
  for (std::size_t i = 0; i < count; ++i) corners[i] = Vec3(element.corner[i].data());
  return geometry::part_in_cell(probe, {corners.data(), count});
}

/// Do the elements around the probe touch this one?
bool touches(const Probe& probe, std::span<const GlobalIndex> element) {
  return std::ranges::any_of(element, [&](GlobalIndex gid) {
    return gid != no_index && std::ranges::find(probe.around, gid) != probe.around.end();
  });
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
    double depth = std::numeric_limits<double>::infinity(), share = 0;
  };
  void list_probes();
  [[nodiscard]] const Probe& probe_of(const Inside& inside) const { return probes_[inside.probe]; }
  [[nodiscard]] Vec3 middle_of(const Inside& inside) const {
    const Segment& all = probe_of(inside).at;
    const double middle = 0.5 * (inside.part.first + inside.part.last);
    return (1 - middle) * all.start + middle * all.end;
  }
  [[nodiscard]] Vec3 at(LocalIndex surface_node) const {
    return position_[watched_.surface.model_node[static_cast<std::size_t>(surface_node)]];
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
  [[nodiscard]] std::vector<GhostSide> own_sides() const;
  void measure(Inside& inside, const std::vector<GhostSide>& sides, std::span<const LocalIndex> near) const;

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
                       .ends = {surface.gid[static_cast<std::size_t>(edge.nodes[0])],
                                surface.gid[static_cast<std::size_t>(edge.nodes[1])]},
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
    const Probe& probe = probes_[static_cast<std::size_t>(p)];
    const GhostElement& element = elements[static_cast<std::size_t>(e)];
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

std::vector<GhostSide> Look::own_sides() const {
  std::vector<GhostSide> sides;
  for (const SurfaceFace& face : watched_.surface.faces) {
    if (watched_.thickness.size() > static_cast<std::size_t>(face.block) &&
        watched_.thickness[static_cast<std::size_t>(face.block)] > 0)
      continue;
    GhostSide side{.key = face.key, .element = face.element, .corner_count = face.corner_count};
    side.element_depth = face.element_depth;
    side.gid.fill(no_index);
    Box box;
    for (std::size_t i = 0; i < side.count(); ++i) {
      const Vec3 x = at(face.nodes[i]);
      side.corner[i] = {x[0], x[1], x[2]};
      side.gid[i] = watched_.surface.gid[static_cast<std::size_t>(face.nodes[i])];
      geometry::extend(box, x);
    }
    side.capture = PlainBox(geometry::grown(box, 2 * face.element_depth));
    sides.push_back(side);
  }
  return sides;
}

void Look::measure() {
  if (!watched_.ranks.any(!inside_.empty())) return;
  std::vector<Vec3> points;
  std::vector<Box> wanted, boxes;
  for (const Inside& inside : inside_) {
    points.push_back(middle_of(inside));
    wanted.push_back({points.back(), points.back()});
  }
  std::vector<GhostSide> sides = own_sides();
  const std::vector<GhostSide> ghosts =
      ghost(watched_.ranks, std::span<const GhostSide>(sides), wanted, 2 * watched_.surface.mean_edge);
  sides.insert(sides.end(), ghosts.begin(), ghosts.end());
  std::ranges::sort(sides, {}, &GhostSide::key);
  for (const GhostSide& side : sides) boxes.push_back(side.capture.box());
  SearchScratch scratch;
  Ragged<LocalIndex> pairs;
  find_pairs(boxes, points, scratch, pairs);
  for (std::size_t k = 0; k < inside_.size(); ++k)
    measure(inside_[k], sides, std::as_const(pairs).row(static_cast<LocalIndex>(k)));
}

/// The distance to the nearest face. An edge that passes through a plate is never far from one: there it is the shorter
/// one of what is inside, and of the distance to the nearest face that the edge can lie on.
void Look::measure(Inside& inside, const std::vector<GhostSide>& sides, std::span<const LocalIndex> near) const {
  const Probe& probe = probe_of(inside);
  const Vec3 x = middle_of(inside);
  std::vector<Vec3> own;  // normals of the faces that meet in the edge
  std::vector<LocalIndex> of_own;
  if (probe.on_edge)
    for (const LocalIndex s : near) {
      const GhostSide& side = sides[static_cast<std::size_t>(s)];
      const auto has = [&](GlobalIndex gid) { return std::ranges::find(side.gid, gid) != side.gid.end(); };
      if (!std::ranges::all_of(probe.ends, has)) continue;
      of_own.push_back(static_cast<LocalIndex>(own.size()));
      own.push_back(side.normal());
    }
  double nearest = std::numeric_limits<double>::infinity(), opposed = nearest;
  double element_depth = watched_.surface.mean_element_depth;
  for (const LocalIndex s : near) {
    const GhostSide& side = sides[static_cast<std::size_t>(s)];
    if (touches(probe, side.element)) continue;
    const std::array<Vec3, 4> corners = side.corners();
    const auto closest = geometry::closest_point(x, {corners.data(), side.count()});
    if (!closest) continue;
    const double distance = (x - closest->point).norm();
    if (distance < nearest) {
      nearest = distance;
      element_depth = side.element_depth;
    }
    if (probe.on_edge && distance < opposed &&
        admission({of_own, own}, side.normal(), false) >= watched_.tolerances.slight)
      opposed = distance;
  }
  if (!(nearest < 2 * element_depth)) nearest = 2 * element_depth;  // faces farther away were not offered
  inside.depth = probe.on_edge ? std::max(nearest, std::min(opposed, inside.chord)) : nearest;
  inside.share = inside.depth / element_depth;
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
    const bool is_equal = worst != nullptr && inside.share == worst->share;  // then the lowest node
    if (worst == nullptr || inside.share > worst->share || (is_equal && probe_of(inside).ends < probe_of(*worst).ends))
      worst = &inside;
  }
  all.count = ranks.sum(all.count);
  const double most = ranks.max(worst != nullptr ? worst->share : 0.0);
  if (!(most > 0)) return all;
  const bool may_be_mine = worst != nullptr && worst->share == most;
  const double infinity = std::numeric_limits<double>::infinity();
  const double node = ranks.min(may_be_mine ? static_cast<double>(probe_of(*worst).ends[0]) : infinity);
  std::array<double, 4> words;
  words.fill(-infinity);
  if (may_be_mine && static_cast<double>(probe_of(*worst).ends[0]) == node)
    words = {static_cast<double>(probe_of(*worst).blocks.front()), static_cast<double>(worst->block), worst->depth,
             probe_of(*worst).on_edge ? 1.0 : 0.0};
  ranks.max(words);
  all.worst = {.node = static_cast<GlobalIndex>(node),
               .node_block = static_cast<std::int32_t>(words[0]),
               .block = static_cast<std::int32_t>(words[1]),
               .depth = words[2],
               .share = most,
               .on_edge = words[3] > 0};
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
