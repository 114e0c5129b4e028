// SPDX-License-Identifier: Apache-2.0
// Trees of k-DOPs: counts of pairs and tests against reference-mortar.md M9, pairs against all pairs of facets.
#include "contact/search/facet_tree.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>
#include <random>

#include "support/torus_facets.hpp"

using namespace brunt;
using namespace brunt::contact;
using test::FacetSurface;

namespace {

template <int slabs>
FacetTree<slabs> tree_of(const FacetSurface& surface, const Enlargement& by) {
  FacetTree<slabs> tree;
  build<slabs>(tree, surface.facets, surface.positions);
  refit<slabs>(tree, surface.positions, by);
  return tree;
}

struct Counts {
  std::int64_t pairs, slave_first, larger_first;
};

template <int slabs>
Counts counts_of(const FacetSurface& a, const FacetSurface& b, const Enlargement& by) {
  const auto slave = tree_of<slabs>(a, by), master = tree_of<slabs>(b, by);
  TraversalScratch scratch;
  std::vector<FacetPair> pairs, same;
  const TraversalCounts first = find_pairs(slave, master, scratch, same, Descent::slave);
  const TraversalCounts larger = find_pairs(slave, master, scratch, pairs);
  CHECK(pairs == same);
  CHECK(larger.pairs == static_cast<std::int64_t>(pairs.size()));
  return {larger.pairs, first.tests, larger.tests};
}

/// Enlargement in the slabs' own coordinates, as the first columns of M9 have it.
Enlargement unnormalised(double d) {
  return {d, d};
}

/// One line of M9; tests of the 18-DOPs in unnormalised enlargement.
struct Line {
  int around;
  double d;
  std::array<std::int64_t, 2> boxes;  ///< from, to: some pairs touch exactly
  std::int64_t kdops, by_distance, slave_first, larger_first;
};

void check_line(const Line& line, const test::Pose& a, const test::Pose& b) {
  INFO(line.around << " around");
  const FacetSurface slave = test::torus_facets(line.around, a), master = test::torus_facets(line.around, b);
  const std::int64_t boxes = counts_of<3>(slave, master, unnormalised(line.d)).pairs;
  CHECK(boxes >= line.boxes[0]);
  CHECK(boxes <= line.boxes[1]);
  const Counts kdops = counts_of<9>(slave, master, unnormalised(line.d));
  CHECK(kdops.pairs == line.kdops);
  // tests depend on how equal centres are ordered: 1 % (M9)
  CHECK(static_cast<double>(kdops.slave_first) == Approx(static_cast<double>(line.slave_first)).epsilon(0.01));
  CHECK(static_cast<double>(kdops.larger_first) == Approx(static_cast<double>(line.larger_first)).epsilon(0.01));
  CHECK(counts_of<9>(slave, master, by_distance(line.d)).pairs == line.by_distance);
}

/// Half a ring's surface of radius 10 from an angle on, as a strip of quads between z = 0 and 1. Between the two planes
/// an 18-DOP has the pairs of the 8-DOP of the plane: the slabs with z in them separate nothing that x or y do not.
FacetSurface half_ring(int facets, double from, const Vec3& centre) {
  FacetSurface surface;
  for (LocalIndex i = 0; i <= facets; ++i) {
    const double angle = from + std::numbers::pi * i / facets;
    for (const double z : {0.0, 1.0})
      surface.positions.push_back(centre + Vec3(10 * std::cos(angle), 10 * std::sin(angle), z));
    if (i < facets) surface.facets.push_back({2 * i, 2 * i + 2, 2 * i + 3, 2 * i + 1});
  }
  return surface;
}

/// A wavy strip of quads and triangles with every node displaced at random.
FacetSurface random_surface(std::mt19937& random) {
  std::uniform_int_distribution<int> count(1, 7);
  std::uniform_real_distribution<double> shift(-0.3, 0.3), angle(0, 6);
  const int along = count(random), across = count(random);
  const double wave = angle(random), phase = angle(random), height = shift(random);
  FacetSurface surface;
  for (int i = 0; i <= along; ++i)
    for (int j = 0; j <= across; ++j)
      surface.positions.emplace_back(i + shift(random), j + shift(random),
                                     height + std::sin(wave * (i + j) + phase) + shift(random));
  const auto node = [&](int i, int j) { return static_cast<LocalIndex>(i * (across + 1) + j); };
  for (int i = 0; i < along; ++i)
    for (int j = 0; j < across; ++j) {
      const FacetNodes quad{node(i, j), node(i + 1, j), node(i + 1, j + 1), node(i, j + 1)};
      if (random() % 3 != 0) {
        surface.facets.push_back(quad);
      } else {
        surface.facets.push_back({quad[0], quad[1], quad[2], no_index});
        surface.facets.push_back({quad[0], quad[2], quad[3], no_index});
      }
    }
  return surface;
}

void displace(FacetSurface& surface, std::mt19937& random) {
  std::uniform_real_distribution<double> shift(-0.4, 0.4);
  for (Vec3& x : surface.positions) x += Vec3(shift(random), shift(random), shift(random));
}

/// Least and greatest projection of a facet, in plain sums.
std::array<double, 2> interval(const FacetSurface& surface, std::size_t facet, const Vec3& direction, double margin) {
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (const LocalIndex corner : surface.facets[facet]) {
    if (corner == no_index) continue;
    const double along = direction.dot(surface.positions[static_cast<std::size_t>(corner)]);
    low = std::min(low, along);
    high = std::max(high, along);
  }
  return {low - margin, high + margin};
}

std::vector<FacetPair> all_pairs(const FacetSurface& a, const FacetSurface& b, double d, int slabs) {
  const std::vector<Vec3> directions{{1, 0, 0}, {0, 1, 0},  {0, 0, 1}, {1, 1, 0}, {1, -1, 0},
                                     {1, 0, 1}, {1, 0, -1}, {0, 1, 1}, {0, 1, -1}};
  TraversalScratch scratch;
  std::vector<FacetPair> pairs;
  for (std::size_t i = 0; i < a.facets.size(); ++i)
    for (std::size_t k = 0; k < b.facets.size(); ++k) {
      const auto overlap_along = [&](const Vec3& direction) {
        const double margin = direction.norm() * d;
        const auto p = interval(a, i, direction, margin), q = interval(b, k, direction, margin);
        return p[0] <= q[1] && q[0] <= p[1];
      };
      if (std::all_of(directions.begin(), directions.begin() + slabs, overlap_along))
        pairs.push_back({static_cast<LocalIndex>(i), static_cast<LocalIndex>(k)});
    }
  return pairs;
}

/// Pairs of trees that were built before the surfaces moved; how many there were.
template <int slabs>
std::size_t check_random(int surfaces, unsigned seed) {
  std::mt19937 random(seed);
  std::size_t found = 0;
  TraversalScratch scratch;
  std::vector<FacetPair> pairs;
  for (int k = 0; k < surfaces; ++k) {
    FacetSurface a = random_surface(random), b = random_surface(random);
    const double d = k % 3 == 0 ? 0.0 : 0.1;
    auto slave = tree_of<slabs>(a, by_distance(d)), master = tree_of<slabs>(b, by_distance(d));
    for (const bool moved : {false, true}) {
      if (moved) {
        displace(a, random);
        displace(b, random);
        refit<slabs>(slave, a.positions, by_distance(d));
        refit<slabs>(master, b.positions, by_distance(d));
      }
      find_pairs(slave, master, scratch, pairs, k % 2 == 0 ? Descent::larger : Descent::slave);
      REQUIRE(pairs == all_pairs(a, b, d, slabs));
      found += pairs.size();
    }
  }
  return found;
}

}  // namespace

TEST_CASE("facet trees: counts of pairs and of tests for two tori are those of M9") {
  const std::array<Line, 2> on_each_other{
      {{40, 1, {1059, 1060}, 758, 820, 6711, 5279}, {80, .5, {3562, 3562}, 2198, 2504, 26445, 15401}}};
  for (const Line& line : on_each_other) check_line(line, {}, test::stacked());
  check_line({160, .25, {5950, 5950}, 3690, 4066, 74873, 32811}, {}, test::stacked());

  const test::Pose a{test::upright(), Vec3::Zero()};
  const test::Pose near{test::upright_turned(), Vec3(116.6, 0, 116.6)};
  check_line({40, 1, {234, 234}, 107, 119, 1329, 933}, a, near);
  check_line({80, .5, {531, 531}, 227, 262, 3851, 2099}, a, near);
  check_line({160, .25, {998, 998}, 451, 508, 12273, 4123}, a, near);
}

TEST_CASE("facet trees: counts of pairs of two half rings are those of M9") {
  struct Shifted {
    double by;
    std::int64_t boxes, kdops;
  };
  const std::array<std::pair<int, std::array<Shifted, 3>>, 2> meshes{
      {{50, {{{0, 3, 0}, {1, 24, 16}, {1.5, 29, 25}}}}, {1000, {{{0, 0, 0}, {1, 100, 78}, {1.5, 30, 18}}}}}};
  for (const auto& [facets, lines] : meshes)
    for (const auto& [by, boxes, kdops] : lines) {
      INFO(facets << " facets, shifted by " << by);
      const Enlargement quarter = by_distance(0.25 * std::numbers::pi * 10 / facets);
      const FacetSurface left = half_ring(facets, std::numbers::pi, Vec3(by, 0, 0));
      const FacetSurface right = half_ring(facets, 0, Vec3(17, -12, 0));
      CHECK(counts_of<3>(left, right, quarter).pairs == boxes);
      const Counts found = counts_of<9>(left, right, quarter);
      CHECK(found.pairs == kdops);
      if (kdops == 0) CHECK(found.larger_first == 1);
    }
}

TEST_CASE("facet trees: 18-DOPs of tori apart are told apart by one test, M9") {
  const double s = std::numbers::sqrt2 / 2;
  const test::Pose about_y{(Mat3() << s, 0, s, 0, 1, 0, -s, 0, s).finished(), Vec3(140, 0, 110)};
  for (const int around : {40, 80}) {
    const FacetSurface a = test::torus_facets(around, {}), b = test::torus_facets(around, about_y);
    const Counts boxes = counts_of<3>(a, b, unnormalised(1)), kdops = counts_of<9>(a, b, by_distance(1));
    CHECK(boxes.pairs == 0);
    CHECK(boxes.slave_first == 1);
    CHECK(kdops.pairs == 0);
    CHECK(kdops.larger_first == 1);
  }
  const FacetSurface a = test::torus_facets(40, {test::upright(), Vec3::Zero()});
  const FacetSurface b = test::torus_facets(40, {test::upright_turned(), Vec3(140, 0, 140)});
  CHECK(counts_of<3>(a, b, unnormalised(1)).pairs == 2);
  const Counts kdops = counts_of<9>(a, b, unnormalised(1));
  CHECK(kdops.pairs == 0);
  CHECK(kdops.slave_first == 1);
  CHECK(counts_of<9>(a, b, by_distance(1)).pairs == 0);
}

TEST_CASE("facet trees: pairs on a thousand random surfaces, also after motion, are those of all pairs") {
  CHECK(check_random<9>(1000, 1) > 10000);
  CHECK(check_random<3>(300, 2) > 3000);
}

TEST_CASE("facet trees: 2 n - 1 nodes, parents first, bounds that hold those of their children") {
  for (const int around : {4, 10, 40}) {
    const FacetSurface surface = test::torus_facets(around, {});
    const KdopTree tree = tree_of<9>(surface, by_distance(0.5));
    const auto n = static_cast<LocalIndex>(surface.facets.size());
    CHECK(tree.facets() == n);
    CHECK(tree.nodes() == 2 * n - 1);
    std::vector<int> seen(surface.facets.size(), 0);
    bool ordered = true, held = true;
    const auto bounds = [&](LocalIndex node) { return tree.bounds[static_cast<std::size_t>(node)]; };
    for (LocalIndex node = 0; node < tree.nodes(); ++node) {
      if (tree.is_leaf(node)) {
        ++seen[static_cast<std::size_t>(tree.facet(node))];
        continue;
      }
      const LocalIndex second = tree.second_child(node);
      ordered = ordered && second > node + 1 && second < tree.nodes();
      const SlabBounds<9> both = united(bounds(node + 1), bounds(second)), own = bounds(node);
      for (int g = 0; g < 3; ++g) held = held && all_lanes((own.low[g] == both.low[g]) & (own.high[g] == both.high[g]));
    }
    CHECK(ordered);
    CHECK(held);
    CHECK(std::ranges::all_of(seen, [](int count) { return count == 1; }));
  }
}

TEST_CASE("facet trees: refits neither allocate nor depend on the positions before") {
  FacetSurface surface = test::torus_facets(20, {});
  KdopTree tree = tree_of<9>(surface, by_distance(0.5));
  const auto* const storage = tree.bounds.data();
  const std::size_t memory = tree.memory_bytes();
  std::mt19937 random(5);
  KdopTree moved = tree;
  displace(surface, random);
  refit<9>(moved, surface.positions, by_distance(0.1));
  surface = test::torus_facets(20, {});
  refit<9>(moved, surface.positions, by_distance(0.5));
  refit<9>(tree, surface.positions, by_distance(0.5));
  CHECK(tree.bounds.data() == storage);
  CHECK(tree.memory_bytes() == memory);
  for (std::size_t i = 0; i < tree.bounds.size(); ++i)
    for (int g = 0; g < 3; ++g)
      REQUIRE(all_lanes((tree.bounds[i].low[g] == moved.bounds[i].low[g]) &
                        (tree.bounds[i].high[g] == moved.bounds[i].high[g])));
}

TEST_CASE("facet trees: a tree without facets, one with a single facet, and facets all in one place") {
  const FacetSurface none;
  FacetSurface one{{{0, 1, 2, no_index}}, {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)}}, many = one;
  many.facets.assign(33, one.facets[0]);
  TraversalScratch scratch;
  std::vector<FacetPair> pairs{{7, 7}};
  CHECK(find_pairs(tree_of<9>(none, {}), tree_of<9>(one, {}), scratch, pairs).tests == 0);
  CHECK(pairs.empty());
  CHECK(find_pairs(tree_of<9>(one, {}), tree_of<9>(one, {}), scratch, pairs).tests == 1);
  CHECK(pairs == std::vector<FacetPair>{{0, 0}});
  CHECK(find_pairs(tree_of<9>(many, {}), tree_of<9>(many, {}), scratch, pairs).pairs == 33 * 33);
  CHECK(std::ranges::is_sorted(pairs));
}

TEST_CASE("facet trees: tests for each pair tell that a tree has lost its order") {
  const FacetSurface a = test::torus_facets(80, {}), b = test::torus_facets(80, test::stacked());
  const auto master = tree_of<9>(b, by_distance(0.5));
  TraversalScratch scratch;
  std::vector<FacetPair> pairs, again;
  const double fresh = find_pairs(tree_of<9>(a, by_distance(0.5)), master, scratch, pairs).tests_per_pair();
  FacetSurface crumpled = a;
  std::mt19937 random(6);
  std::ranges::shuffle(crumpled.positions, random);
  auto worn = tree_of<9>(crumpled, {});
  refit<9>(worn, a.positions, by_distance(0.5));
  CHECK(find_pairs(worn, master, scratch, again).tests_per_pair() > 2 * fresh);
  CHECK(again == pairs);
  CHECK(TraversalCounts{12, 0}.tests_per_pair() == 12);
}
