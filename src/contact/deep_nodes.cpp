// SPDX-License-Identifier: Apache-2.0
#include "brunt/contact/deep_nodes.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>
#include <span>
#include <utility>

#include "brunt/contact/data/tolerances.hpp"
#include "brunt/contact/search/search.hpp"
#include "brunt/core/cells.hpp"
#include "brunt/geometry/closest_point.hpp"

namespace brunt::contact {
namespace {

using geometry::Box;

/// What may lie in an element: a node, or a point of an edge.
struct Probe {
  Vec3 x = Vec3::Zero();
  GlobalIndex node = 0;
  std::int32_t body = 0;
  std::span<const std::int32_t> blocks{};
  std::span<const GlobalIndex> around{};  ///< nodes of its elements
  bool on_edge = false;
};

struct GhostSide {
  GlobalIndex key = 0;
  std::array<std::array<double, 3>, 4> corner{};
  std::array<GlobalIndex, 8> element{};
  std::int32_t corner_count = 4, body = 0;
  double element_depth = 0;
  PlainBox capture{};

  friend bool operator<(const GhostSide& a, const GhostSide& b) { return a.key < b.key; }
};

bool in_tetrahedron(const Vec3& x, const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  const auto volume = [](const Vec3& p, const Vec3& q, const Vec3& r, const Vec3& s) {
    return (q - p).cross(r - p).dot(s - p);
  };
  return volume(a, b, c, d) > 0 && volume(x, b, c, d) >= 0 && volume(a, x, c, d) >= 0 && volume(a, b, x, d) >= 0 &&
         volume(a, b, c, x) >= 0;
}

bool contains(const GhostElement& element, const Vec3& x) {
  const auto corner = [&](int c) { return Vec3(element.corner[static_cast<std::size_t>(c)].data()); };
  if (element.corner_count == 4) return in_tetrahedron(x, corner(0), corner(1), corner(2), corner(3));
  return std::ranges::any_of(cells::hex_tetrahedra, [&](const std::array<int, 4>& tet) {
    return in_tetrahedron(x, corner(tet[0]), corner(tet[1]), corner(tet[2]), corner(tet[3]));
  });
}

/// Do the elements around the probe touch this one?
bool touches(const Probe& probe, std::span<const GlobalIndex> element) {
  return std::ranges::any_of(element, [&](GlobalIndex gid) {
    return gid != no_index && std::ranges::find(probe.around, gid) != probe.around.end();
  });
}

class Look {
 public:
  Look(const Contact& contact, const VectorView& position) : contact_(contact), position_(position) { list_probes(); }

  /// Fills, for each probe, whether an element contains it and of which block.
  void find_inside(std::vector<GhostElement> elements);
  /// Of the probes inside: distance to the nearest exterior face.
  void measure();
  [[nodiscard]] DeepNodes result(double above) const;

 private:
  struct Inside {
    std::size_t probe = 0;
    std::int32_t block = 0;
    double depth = std::numeric_limits<double>::infinity(), share = 0;
  };
  void list_probes();
  [[nodiscard]] Vec3 at(LocalIndex surface_node) const {
    return position_[contact_.surface.model_node[static_cast<std::size_t>(surface_node)]];
  }
  [[nodiscard]] bool may_meet(const Probe& probe, std::int32_t block) const {
    const PairTable& pairs = contact_.settings.specification.pairs;
    return std::ranges::any_of(probe.blocks, [&](std::int32_t own) {
      const PairSpecification& pair = pairs.at(own, block);
      return pair.rule != PairRule::apart && pair.tied == Tied::no;
    });
  }
  [[nodiscard]] std::vector<GhostSide> own_sides() const;

  const Contact& contact_;
  const VectorView& position_;
  std::vector<Probe> probes_;
  std::vector<Inside> inside_;
};

void Look::list_probes() {
  const Surface& surface = contact_.surface;
  for (LocalIndex node = 0; node < static_cast<LocalIndex>(surface.gid.size()); ++node) {
    const auto i = static_cast<std::size_t>(node);
    if (!surface.owns(node, contact_.ranks.rank()) || surface.blocks.row(node).empty()) continue;
    probes_.push_back(
        {at(node), surface.gid[i], surface.body[i], surface.blocks.row(node), surface.neighbours.row(node), false});
  }
  constexpr std::array places{0.25, 0.5, 0.75};
  for (const SurfaceEdge& edge : surface.edges) {
    if (edge.kind != EdgeKind::sharp) continue;
    const Vec3 start = at(edge.nodes[0]), end = at(edge.nodes[1]);
    for (const double place : places)
      probes_.push_back({(1 - place) * start + place * end, surface.gid[static_cast<std::size_t>(edge.nodes[0])],
                         edge.body, std::span(&edge.block, 1), edge.elements, true});
  }
}

void Look::find_inside(std::vector<GhostElement> elements) {
  std::vector<Vec3> points;
  std::vector<Box> wanted;
  for (const Probe& probe : probes_) {
    points.push_back(probe.x);
    wanted.push_back({probe.x, probe.x});
  }
  const double finest = 2 * contact_.surface.mean_edge;
  const std::vector<GhostElement> ghosts =
      ghost(contact_.ranks, std::span<const GhostElement>(elements), wanted, finest);
  elements.insert(elements.end(), ghosts.begin(), ghosts.end());
  std::vector<Box> boxes;
  boxes.reserve(elements.size());
  for (const GhostElement& element : elements) boxes.push_back(element.capture.box());
  SearchScratch scratch;
  Ragged<LocalIndex> pairs;
  find_pairs(boxes, points, scratch, pairs);
  for (std::size_t p = 0; p < probes_.size(); ++p) {
    const GhostElement* found = nullptr;  // the lowest, whatever their order here
    for (const LocalIndex e : std::as_const(pairs).row(static_cast<LocalIndex>(p))) {
      const GhostElement& element = elements[static_cast<std::size_t>(e)];
      if (found != nullptr && found->gid < element.gid) continue;
      if (!may_meet(probes_[p], element.block) || touches(probes_[p], element.nodes)) continue;
      if (contains(element, probes_[p].x)) found = &element;
    }
    if (found == nullptr) continue;
    inside_.push_back({.probe = p, .block = found->block});
  }
}

std::vector<GhostSide> Look::own_sides() const {
  std::vector<GhostSide> sides;
  for (const SurfaceFace& face : contact_.surface.faces) {
    if (contact_.settings.blocks.thickness.size() > static_cast<std::size_t>(face.block) &&
        contact_.settings.blocks.thickness[static_cast<std::size_t>(face.block)] > 0)
      continue;
    GhostSide side{.key = face.key, .element = face.element, .corner_count = face.corner_count, .body = face.body};
    side.element_depth = face.element_depth;
    Box box;
    for (std::size_t i = 0; i < static_cast<std::size_t>(face.corner_count); ++i) {
      const Vec3 x = at(face.nodes[i]);
      side.corner[i] = {x[0], x[1], x[2]};
      geometry::extend(box, x);
    }
    side.capture = PlainBox(geometry::grown(box, 2 * face.element_depth));
    sides.push_back(side);
  }
  return sides;
}

void Look::measure() {
  if (!contact_.ranks.any(!inside_.empty())) return;
  std::vector<Vec3> points;
  std::vector<Box> wanted;
  for (const Inside& inside : inside_) {
    points.push_back(probes_[inside.probe].x);
    wanted.push_back({points.back(), points.back()});
  }
  std::vector<GhostSide> sides = own_sides();
  const std::vector<GhostSide> ghosts =
      ghost(contact_.ranks, std::span<const GhostSide>(sides), wanted, 2 * contact_.surface.mean_edge);
  sides.insert(sides.end(), ghosts.begin(), ghosts.end());
  std::vector<Box> boxes;
  for (const GhostSide& side : sides) boxes.push_back(side.capture.box());
  SearchScratch scratch;
  Ragged<LocalIndex> pairs;
  find_pairs(boxes, points, scratch, pairs);
  for (std::size_t k = 0; k < inside_.size(); ++k) {
    Inside& inside = inside_[k];
    const Probe& probe = probes_[inside.probe];
    inside.share = 2;  // no face within two elements
    inside.depth = 2 * contact_.surface.mean_element_depth;
    double nearest = std::numeric_limits<double>::infinity();
    for (const LocalIndex s : std::as_const(pairs).row(static_cast<LocalIndex>(k))) {
      const GhostSide& side = sides[static_cast<std::size_t>(s)];
      if (touches(probe, side.element)) continue;
      std::array<Vec3, 4> corners;
      const auto count = static_cast<std::size_t>(side.corner_count);
      for (std::size_t i = 0; i < count; ++i) corners[i] = Vec3(side.corner[i].data());
      const auto closest = geometry::closest_point(probe.x, {corners.data(), count});
      if (!closest) continue;
      const double distance = (probe.x - closest->point).norm();
      if (!(distance < nearest)) continue;
      nearest = distance;
      inside.depth = distance;
      inside.share = distance / side.element_depth;
    }
  }
}

DeepNodes Look::result(double above) const {
  const comm::Communicator& ranks = contact_.ranks;
  DeepNodes all;
  const Inside* worst = nullptr;
  GlobalIndex last_edge = no_index;
  for (const Inside& inside : inside_) {
    const Probe& probe = probes_[inside.probe];
    if (inside.share > above && !(probe.on_edge && probe.node == last_edge)) ++all.count;
    if (inside.share > above && probe.on_edge) last_edge = probe.node;
    if (worst == nullptr || inside.share > worst->share) worst = &inside;
  }
  all.count = ranks.sum(all.count);
  const double most = ranks.max(worst != nullptr ? worst->share : 0.0);
  if (!(most > 0)) return all;
  const bool may_be_mine = worst != nullptr && worst->share == most;
  const double infinity = std::numeric_limits<double>::infinity();
  const double node = ranks.min(may_be_mine ? static_cast<double>(probes_[worst->probe].node) : infinity);
  std::array<double, 5> words;
  words.fill(-infinity);
  if (may_be_mine && static_cast<double>(probes_[worst->probe].node) == node)
    words = {static_cast<double>(probes_[worst->probe].blocks.front()), static_cast<double>(worst->block), worst->depth,
             probes_[worst->probe].on_edge ? 1.0 : 0.0, 0};
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

DeepNodes find_deep_nodes(const Contact& contact, const VectorView& position, const std::vector<GhostElement>& elements,
                          double above) {
  Look look(contact, position);
  look.find_inside(elements);
  look.measure();
  return look.result(above);
}

}  // namespace brunt::contact
