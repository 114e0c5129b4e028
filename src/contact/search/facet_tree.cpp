// SPDX-License-Identifier: Apache-2.0
// Trees of facets: build by medians, refit by unions, tandem traversal.
#include "contact/search/facet_tree.hpp"

#include <algorithm>

#include "geometry/box.hpp"

namespace brunt::contact {
namespace {

struct Item {
  Vec3 centre;
  LocalIndex facet = no_index;
};
using Items = std::span<Item>;

int longest_side(Items items) {
  geometry::Box box;
  for (const Item& item : items) extend(box, item.centre);
  int axis = 0;
  (box.high - box.low).maxCoeff(&axis);
  return axis;
}

/// Puts those below the median in front.
void halve(Items items) {
  const int axis = longest_side(items);
  std::ranges::nth_element(items, items.begin() + static_cast<std::ptrdiff_t>(items.size() / 2),
                           [axis](const Item& a, const Item& b) {
                             if (a.centre[axis] != b.centre[axis]) return a.centre[axis] < b.centre[axis];
                             return a.facet < b.facet;
                           });
}

template <int slabs>
void add_nodes(FacetTree<slabs>& tree, Items items, std::span<const FacetNodes> facets) {
  const auto node = tree.link.size();
  const std::size_t first = items.size() / 2;
  if (items.size() == 1) {
    FacetNodes corners = nth(facets, items[0].facet);
    if (corners[3] == no_index) corners[3] = corners[2];
    tree.link.push_back(~items[0].facet);
    tree.corners.push_back(corners);
    return;
  }
  tree.link.push_back(static_cast<LocalIndex>(node + 2 * first));
  halve(items);
  add_nodes(tree, items.first(first), facets);
  add_nodes(tree, items.subspan(first), facets);
}

Vec3 centre_of(const FacetNodes& corners, std::span<const Vec3> positions) {
  Vec3 sum = Vec3::Zero();
  int count = 0;
  for (const LocalIndex corner : corners) {
    if (corner == no_index) continue;
    sum += nth(positions, corner);
    ++count;
  }
  return sum / count;
}

/// By slave by counting, then the few of each by master: a third of the time of a sort of all pairs.
void order_pairs(LocalIndex slaves, TraversalScratch& scratch, std::vector<FacetPair>& pairs) {
  const auto& found = scratch.found;
  auto& end = scratch.end;
  end.assign(static_cast<std::size_t>(slaves) + 1, 0);
  for (const FacetPair& pair : found) ++end[static_cast<std::size_t>(pair.slave) + 1];
  for (std::size_t s = 1; s < end.size(); ++s) end[s] += end[s - 1];
  pairs.resize(found.size());
  for (const FacetPair& pair : found) nth(pairs, nth(end, pair.slave)++) = pair;
  auto first = pairs.begin();
  for (std::size_t s = 0; s + 1 < end.size(); ++s) {
    const auto last = pairs.begin() + end[s];
    std::sort(first, last, [](const FacetPair& a, const FacetPair& b) { return a.master < b.master; });
    first = last;
  }
}

/// Nodes that overlap and wait for their children. Each step down leaves one waiting, and halving 2^31 facets takes 31
/// steps in each tree.
struct Waiting {
  struct Nodes {
    LocalIndex slave = 0, master = 0;
  };
  std::array<Nodes, 64> nodes;
  std::size_t count = 0;
  void push(LocalIndex slave, LocalIndex master) { nodes[count++] = {slave, master}; }
  Nodes pop() { return nodes[--count]; }
};

}  // namespace

template <int slabs>
std::size_t FacetTree<slabs>::memory_bytes() const {
  return bounds.capacity() * sizeof(bounds[0]) + link.capacity() * sizeof(link[0]) +
         corners.capacity() * sizeof(corners[0]);
}

template <int slabs>
void build(FacetTree<slabs>& tree, std::span<const FacetNodes> facets, std::span<const Vec3> positions) {
  tree.link.clear();
  tree.corners.clear();
  const std::size_t nodes = facets.empty() ? 0 : 2 * facets.size() - 1;
  tree.link.reserve(nodes);
  tree.corners.reserve(facets.size());
  tree.bounds.resize(nodes);
  std::vector<Item> items;
  items.reserve(facets.size());
  for (const FacetNodes& corners : facets)
    items.push_back({centre_of(corners, positions), static_cast<LocalIndex>(items.size())});
  if (!items.empty()) add_nodes<slabs>(tree, items, facets);
}

template <int slabs>
void refit(FacetTree<slabs>& tree, std::span<const Vec3> positions, const Enlargement& by) {
  const auto at = [&](LocalIndex corner) -> const Vec3& { return nth(positions, corner); };
  std::size_t leaf = tree.corners.size();
  for (std::size_t node = tree.link.size(); node-- > 0;) {
    const LocalIndex link = tree.link[node];
    if (link < 0) {
      const auto& [a, b, c, d] = tree.corners[--leaf];
      tree.bounds[node] = bounds_of<slabs>(at(a), at(b), at(c), at(d), by);
    } else {
      tree.bounds[node] = united(tree.bounds[node + 1], nth(tree.bounds, link));
    }
  }
}

template <int slabs>
TraversalCounts find_pairs(const FacetTree<slabs>& slave, const FacetTree<slabs>& master, TraversalScratch& scratch,
                           std::vector<FacetPair>& pairs, Descent descent) {
  const auto bounds_in = [](const FacetTree<slabs>& tree, LocalIndex node) -> const SlabBounds<slabs>& {
    return nth(tree.bounds, node);
  };
  const auto descends_slave = [&](LocalIndex s, LocalIndex m) {
    if (slave.is_leaf(s)) return false;
    return master.is_leaf(m) || descent == Descent::slave || width(bounds_in(slave, s)) >= width(bounds_in(master, m));
  };
  scratch.found.clear();
  TraversalCounts counts;
  Waiting waiting;
  const auto test = [&](LocalIndex s, LocalIndex m) {
    ++counts.tests;
    if (overlap(bounds_in(slave, s), bounds_in(master, m))) waiting.push(s, m);
  };
  if (slave.nodes() > 0 && master.nodes() > 0) test(0, 0);
  while (waiting.count > 0) {
    const auto [s, m] = waiting.pop();
    if (slave.is_leaf(s) && master.is_leaf(m)) {
      scratch.found.push_back({slave.facet(s), master.facet(m)});
    } else if (descends_slave(s, m)) {
      test(s + 1, m);
      test(slave.second_child(s), m);
    } else {
      test(s, m + 1);
      test(s, master.second_child(m));
    }
  }
  order_pairs(slave.facets(), scratch, pairs);
  counts.pairs = static_cast<std::int64_t>(pairs.size());
  return counts;
}

template struct FacetTree<3>;
template struct FacetTree<9>;
template void build(FacetTree<3>&, std::span<const FacetNodes>, std::span<const Vec3>);
template void build(FacetTree<9>&, std::span<const FacetNodes>, std::span<const Vec3>);
template void refit(FacetTree<3>&, std::span<const Vec3>, const Enlargement&);
template void refit(FacetTree<9>&, std::span<const Vec3>, const Enlargement&);
template TraversalCounts find_pairs(const FacetTree<3>&, const FacetTree<3>&, TraversalScratch&,
                                    std::vector<FacetPair>&, Descent);
template TraversalCounts find_pairs(const FacetTree<9>&, const FacetTree<9>&, TraversalScratch&,
                                    std::vector<FacetPair>&, Descent);

}  // namespace brunt::contact
