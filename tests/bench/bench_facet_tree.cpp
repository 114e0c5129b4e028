// SPDX-License-Identifier: Apache-2.0
// Trees of facets on two tori that lie on each other (reference-mortar.md M9, M10): nanoseconds of build and refit a
// facet, microseconds of a search, and how many times longer the test of all pairs of leaves takes.
#include <fmt/core.h>

#include <algorithm>
#include <functional>

#include "contact/search/facet_tree.hpp"
#include "support/processor_time.hpp"
#include "support/torus_facets.hpp"

namespace {

using namespace brunt;
using namespace brunt::contact;

/// Least of so many runs [s of processor time].
double seconds(int runs, const std::function<void()>& work) {
  double least = std::numeric_limits<double>::infinity();
  for (int k = 0; k < runs; ++k) {
    const double start = test::processor_time();
    work();
    least = std::min(least, test::processor_time() - start);
  }
  return least;
}

template <int slabs>
AlignedVector<SlabBounds<slabs>> leaves_of(const FacetTree<slabs>& tree) {
  AlignedVector<SlabBounds<slabs>> leaves;
  for (LocalIndex node = 0; node < tree.nodes(); ++node)
    if (tree.is_leaf(node)) leaves.push_back(tree.bounds[static_cast<std::size_t>(node)]);
  return leaves;
}

/// The same packed tests, in blocks that stay in the cache.
template <int slabs>
std::int64_t all_pairs(const AlignedVector<SlabBounds<slabs>>& slave, const AlignedVector<SlabBounds<slabs>>& master) {
  constexpr std::size_t block = 64;
  std::int64_t count = 0;
  for (std::size_t first = 0; first < master.size(); first += block)
    for (const SlabBounds<slabs>& s : slave)
      for (std::size_t m = first; m < std::min(first + block, master.size()); ++m) count += overlap(s, master[m]);
  return count;
}

template <int slabs>
void measure(int around, double d) {
  const test::FacetSurface a = test::torus_facets(around, {}), b = test::torus_facets(around, test::stacked());
  FacetTree<slabs> slave, master;
  const double build_time = seconds(5, [&] {
    build<slabs>(slave, a.facets, a.positions);
    build<slabs>(master, b.facets, b.positions);
  });
  const double refit_time = seconds(50, [&] {
    refit<slabs>(slave, a.positions, by_distance(d));
    refit<slabs>(master, b.positions, by_distance(d));
  });
  TraversalScratch scratch;
  std::vector<FacetPair> pairs;
  TraversalCounts counts;
  const double search_time = seconds(50, [&] { counts = find_pairs(slave, master, scratch, pairs); });
  const auto slaves = leaves_of(slave), masters = leaves_of(master);
  std::int64_t all = 0;
  const double all_time = seconds(7, [&] { all = all_pairs(slaves, masters); });
  const double facets = 2.0 * slave.facets();
  fmt::print("| 2 x {} | {} | {} | {} | {:.0f} | {:.1f} | {:.0f} | {:.1f} | {:.0f} | 1/{:.0f} |{}\n", slave.facets(),
             2 * slabs, counts.pairs, counts.tests, 1e9 * build_time / facets, 1e9 * refit_time / facets,
             1e6 * search_time, 1e9 * search_time / static_cast<double>(counts.tests), 1e6 * all_time,
             all_time / (refit_time + search_time), all == counts.pairs ? "" : " pairs differ");
}

}  // namespace

int main() {
  fmt::print(
      "| facets | k | pairs | tests | build [ns a facet] | refit [ns a facet] | search [us] | [ns a test] | all pairs "
      "of "
      "leaves [us] | refit + search to all pairs |\n| ---: | ---: | ---: | ---: | ---: | ---: | ---: | ---: | ---: | "
      "---: "
      "|\n");
  for (const auto& [around, d] : {std::pair{40, 1.0}, {80, 0.5}, {160, 0.25}}) {
    measure<9>(around, d);
    measure<3>(around, d);
  }
}
