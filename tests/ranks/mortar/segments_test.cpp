// SPDX-License-Identifier: Apache-2.0
// The pairs of the trees of k-DOPs against all pairs of facets: the same segments, with the same bits, on a thousand
// random surfaces (reference-mortar.md, M9). Ranks share the surfaces; each finds the same sums over all of them.
#include <catch2/catch.hpp>
#include <cmath>
#include <random>
#include <vector>

#include "comm/communicator.hpp"
#include "contact/mortar/interface.hpp"
#include "contact/search/facet_tree.hpp"

using namespace brunt;
using namespace brunt::contact;

namespace {

struct Two {
  MortarSurfaces surfaces;
  std::vector<Vec3> x;
};

/// Two sheets of triangles or quadrilaterals that wave, are noisy, turned, folded over here and there, near each other
/// or through each other: a function of the seed.
class Maker {
 public:
  explicit Maker(unsigned seed) : random_(seed) {}

  Two make() {
    Two two;
    two.surfaces.capture = 0.05 + 0.4 * unit();
    if (unit() < 0.5) two.surfaces.multiplier = Multiplier::standard;
    const double apart = 0.4 * (unit() - 0.3);
    add(two.x, two.surfaces.slave, 0, true);
    const std::size_t slaves = two.x.size();
    add(two.x, two.surfaces.master, apart, false);
    for (std::size_t node = 0; node < slaves; ++node) two.surfaces.rows.push_back(static_cast<LocalIndex>(node));
    return two;
  }

 private:
  double unit() { return std::uniform_real_distribution<double>(0, 1)(random_); }

  void add(std::vector<Vec3>& x, std::vector<FacetNodes>& facets, double height, bool up) {
    const int n = 2 + static_cast<int>(6 * unit()), m = 2 + static_cast<int>(6 * unit());
    const double wave = 0.3 * unit(), length = 1 + 6 * unit(), noise = 0.1 * unit() / n, turn = 0.6 * (unit() - 0.5);
    const bool triangles = unit() < 0.3;
    const auto first = static_cast<LocalIndex>(x.size());
    for (int j = 0; j <= m; ++j)
      for (int i = 0; i <= n; ++i) {
        const double a = static_cast<double>(i) / n - 0.5, b = static_cast<double>(j) / m - 0.5;
        const Vec3 place(std::cos(turn) * a - std::sin(turn) * b, std::sin(turn) * a + std::cos(turn) * b,
                         height + wave * std::sin(length * a) * std::cos(length * b));
        x.push_back(place + noise * Vec3(unit(), unit(), unit()));
      }
    for (int j = 0; j < m; ++j)
      for (int i = 0; i < n; ++i) {
        const LocalIndex a = first + j * (n + 1) + i, b = a + 1, c = b + n + 1, d = c - 1;
        if (triangles) {
          facets.push_back(up ? FacetNodes{a, b, c, no_index} : FacetNodes{a, c, b, no_index});
          facets.push_back(up ? FacetNodes{a, c, d, no_index} : FacetNodes{a, d, c, no_index});
        } else {
          facets.push_back(up ? FacetNodes{a, b, c, d} : FacetNodes{a, d, c, b});
        }
      }
  }

  std::mt19937 random_;
};

Ragged<LocalIndex> all_pairs(const MortarSurfaces& surfaces) {
  Ragged<LocalIndex> candidates;
  for (std::size_t facet = 0; facet < surfaces.slave.size(); ++facet) {
    for (std::size_t c = 0; c < surfaces.master.size(); ++c) candidates.values.push_back(static_cast<LocalIndex>(c));
    candidates.close_row();
  }
  return candidates;
}

Ragged<LocalIndex> of_trees(const Two& two, TraversalScratch& scratch) {
  KdopTree slave, master;
  build(slave, two.surfaces.slave, two.x);
  build(master, two.surfaces.master, two.x);
  refit(slave, two.x, by_distance(0.5 * two.surfaces.capture));
  refit(master, two.x, by_distance(0.5 * two.surfaces.capture));
  std::vector<FacetPair> pairs;
  (void)find_pairs(slave, master, scratch, pairs);
  Ragged<LocalIndex> candidates;
  auto pair = pairs.begin();
  for (LocalIndex facet = 0; facet < static_cast<LocalIndex>(two.surfaces.slave.size()); ++facet) {
    for (; pair != pairs.end() && pair->slave == facet; ++pair) candidates.values.push_back(pair->master);
    candidates.close_row();
  }
  return candidates;
}

}  // namespace

TEST_CASE("the segments of the trees' pairs are those of all pairs, on a thousand random surfaces") {
  const comm::Communicator ranks = comm::Communicator::world();
  constexpr int surfaces = 1000;
  GlobalIndex segments = 0, tested = 0, differing = 0, touched = 0;
  TraversalScratch scratch;
  for (int seed = ranks.rank(); seed < surfaces; seed += ranks.size()) {
    const Two two = Maker(static_cast<unsigned>(seed)).make();
    const MortarTopology topology = make_topology(two.surfaces, two.x);
    const MortarScratchPointer work = make_mortar_scratch();
    const Ragged<LocalIndex> candidates = of_trees(two, scratch);
    MortarRows of_all, of_pairs;
    mortar_rows(two.surfaces, topology, all_pairs(two.surfaces), two.x, *work, of_all);
    mortar_rows(two.surfaces, topology, candidates, two.x, *work, of_pairs);
    segments += static_cast<GlobalIndex>(of_all.segments);
    tested += static_cast<GlobalIndex>(candidates.values.size());
    touched += of_all.segments > 0 ? 1 : 0;
    const bool same = of_all.segments == of_pairs.segments && of_all.gaps == of_pairs.gaps &&
                      of_all.weights.nodes.values == of_pairs.weights.nodes.values &&
                      of_all.weights.blocks == of_pairs.weights.blocks;
    differing += same ? 0 : 1;
  }
  CHECK(ranks.sum(differing) == 0);
  CHECK(ranks.sum(touched) > 900);
  CHECK(ranks.sum(segments) > 20 * surfaces);
  CHECK(ranks.sum(tested) > ranks.sum(segments));
}
