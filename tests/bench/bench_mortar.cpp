// SPDX-License-Identifier: Apache-2.0
// Microseconds of one core for the mortar integrals of a pair that overlaps, without and with derivatives, and for the
// rows of two surfaces a segment; and the whole of contact - trees refitted, searched, rows - beside the projection of
// every pair of facets (reference-mortar.md, M10).
#include <fmt/core.h>

#include <algorithm>
#include <limits>
#include <numbers>

#include "contact/mortar/tractions.hpp"
#include "contact/search/facet_tree.hpp"
#include "support/processor_time.hpp"
#include "support/torus_facets.hpp"
#include "unit/contact/mortar/facet_pairs.hpp"
#include "unit/contact/mortar/two_surfaces.hpp"

using namespace brunt;
using namespace brunt::contact;

namespace {

/// Least of several repeats, in microseconds of processor time.
template <class Work>
double microseconds(int repeats, const Work& work) {
  double least = std::numeric_limits<double>::infinity();
  for (int repeat = 0; repeat < repeats; ++repeat) {
    const double start = test::processor_time();
    work();
    least = std::min(least, 1e6 * (test::processor_time() - start));
  }
  return least;
}

void measure_pairs(const char* name, int slave_corners, int master_corners) {
  constexpr double anywhere = std::numeric_limits<double>::infinity();
  test::RandomPairs random(1);
  std::vector<test::FacetPair> pairs;
  SlavePlane plane;
  SegmentIntegrals integrals;
  SegmentSlopes slopes;
  while (pairs.size() < 200) {
    pairs.push_back(random(slave_corners, master_corners));
    if (!make_slave_plane(pairs.back().slave, plane) ||
        !integrate_segment(plane, pairs.back().master, anywhere, integrals))
      pairs.pop_back();
  }
  const auto run = [&](SegmentSlopes* with) {
    for (const test::FacetPair& pair : pairs) {
      make_slave_plane(pair.slave, plane);
      integrate_segment(plane, pair.master, anywhere, integrals, with);
    }
  };
  const auto count = static_cast<double>(pairs.size());
  const double value = microseconds(300, [&] { run(nullptr); }) / count,
               derivative = microseconds(300, [&] { run(&slopes); }) / count;
  fmt::print("{:<28}{:8.2f}{:12.2f}{:8.2f}\n", name, value, derivative, derivative / value);
}

/// Leaves the pairs whose centres are nearer than the sum of the half diagonals, as a search would.
void keep_near(test::TwoSurfaces& two) {
  const auto centre = [&](const FacetNodes& facet) {
    return Vec3(0.5 * (two.x[static_cast<std::size_t>(facet[0])] + two.x[static_cast<std::size_t>(facet[2])]));
  };
  two.candidates.clear();
  for (const FacetNodes& slave : two.surfaces.slave) {
    for (std::size_t c = 0; c < two.surfaces.master.size(); ++c)
      if ((centre(slave) - centre(two.surfaces.master[c])).norm() < 0.11)
        two.candidates.values.push_back(static_cast<LocalIndex>(c));
    two.candidates.close_row();
  }
}

void measure_rows() {
  const auto place = [](double height) {
    return [height](double x, double y) { return Vec3(x + 0.05 * y, y, height + 0.02 * x * y); };
  };
  for (const Multiplier multiplier : {Multiplier::standard, Multiplier::dual}) {
    test::TwoSurfaces two({12, 12, 0, 1, 0, 1, true, false}, place(0), {15, 15, 0, 1, 0, 1, false, false}, place(0.01));
    two.surfaces.multiplier = multiplier;
    keep_near(two);
    const MortarTopology topology = make_topology(two.surfaces, two.x);
    const MortarScratchPointer scratch = make_mortar_scratch();
    MortarRows rows;
    MortarSlopes slopes;
    const double value =
        microseconds(30, [&] { mortar_rows(two.surfaces, topology, two.candidates, two.x, *scratch, rows); });
    const std::vector<double> z(two.surfaces.rows.size(), 1);
    std::vector<Vec3> tractions;
    normal_tractions(rows, z, tractions);
    const double derivative = microseconds(10, [&] {
      mortar_rows_and_slopes(two.surfaces, topology, two.candidates, two.x, tractions, *scratch, rows, slopes);
    });
    const auto segments = static_cast<double>(rows.segments);
    fmt::print("{:<28}{:8.2f}{:12.2f}{:8.2f}   {} segments of {} pairs\n",
               multiplier == Multiplier::dual ? "rows, dual" : "rows, standard", value / segments,
               derivative / segments, derivative / value, rows.segments, two.candidates.values.size());
  }
}

/// The half of a ring of radius 10 that looks to one side, as a slab .5 thick.
test::FacetSurface half_ring(int facets, const Vec3& centre, double from) {
  test::FacetSurface surface;
  for (int i = 0; i <= facets; ++i) {
    const double angle = from + std::numbers::pi * i / facets;
    for (const double z : {0.0, 0.5})
      surface.positions.push_back(centre + Vec3(10 * std::cos(angle), 10 * std::sin(angle), z));
  }
  for (LocalIndex i = 0; i < facets; ++i) surface.facets.push_back({2 * i, 2 * i + 2, 2 * i + 3, 2 * i + 1});
  return surface;
}

/// Both surfaces in one array of nodes; facets meet that are nearer than d.
struct Pair {
  MortarSurfaces surfaces;
  std::vector<Vec3> x;

  Pair(const test::FacetSurface& slave, const test::FacetSurface& master, double d) {
    surfaces.capture = d;
    surfaces.slave = slave.facets;
    x = slave.positions;
    const auto first = static_cast<LocalIndex>(x.size());
    for (LocalIndex node = 0; node < first; ++node) surfaces.rows.push_back(node);
    x.insert(x.end(), master.positions.begin(), master.positions.end());
    for (FacetNodes facet : master.facets) {
      for (LocalIndex& node : facet) node += first;
      surfaces.master.push_back(facet);
    }
  }
};

void all_candidates(const MortarSurfaces& surfaces, Ragged<LocalIndex>& candidates) {
  candidates.clear();
  for (std::size_t facet = 0; facet < surfaces.slave.size(); ++facet) {
    for (std::size_t c = 0; c < surfaces.master.size(); ++c) candidates.values.push_back(static_cast<LocalIndex>(c));
    candidates.close_row();
  }
}

void measure_whole(const char* name, const Pair& pair, double aim) {
  const MortarTopology topology = make_topology(pair.surfaces, pair.x);
  const MortarScratchPointer scratch = make_mortar_scratch();
  KdopTree slave, master;
  build<9>(slave, pair.surfaces.slave, pair.x);
  build<9>(master, pair.surfaces.master, pair.x);
  TraversalScratch traversal;
  std::vector<contact::FacetPair> found;
  Ragged<LocalIndex> candidates;
  MortarRows rows, of_all;
  const Enlargement half = by_distance(0.5 * pair.surfaces.capture);
  const double whole = microseconds(30, [&] {
    refit<9>(slave, pair.x, half);
    refit<9>(master, pair.x, half);
    find_pairs(slave, master, traversal, found);
    candidates.clear();
    auto next = found.begin();
    for (LocalIndex facet = 0; facet < static_cast<LocalIndex>(pair.surfaces.slave.size()); ++facet) {
      for (; next != found.end() && next->slave == facet; ++next) candidates.values.push_back(next->master);
      candidates.close_row();
    }
    mortar_rows(pair.surfaces, topology, candidates, pair.x, *scratch, rows);
  });
  Ragged<LocalIndex> all;
  all_candidates(pair.surfaces, all);
  const double every = microseconds(3, [&] { mortar_rows(pair.surfaces, topology, all, pair.x, *scratch, of_all); });
  fmt::print("| {} | {} | {} | {:.0f} | {:.0f} | 1/{:.0f} | 1/{:.0f} |{}\n", name, found.size(), rows.segments, whole,
             every, every / whole, aim, rows.segments == of_all.segments ? "" : " segments differ");
}

}  // namespace

int main() {
  fmt::print("{:<28}{:>8}{:>12}{:>8}   [us a segment]\n", "", "values", "derivatives", "ratio");
  measure_pairs("quad on quad", 4, 4);
  measure_pairs("triangle on quad", 3, 4);
  measure_pairs("triangle on triangle", 3, 3);
  measure_rows();
  fmt::print(
      "\n| whole contact | pairs | segments | refit, search, rows [us] | rows of every pair [us] | ratio | aim |\n"
      "| --- | ---: | ---: | ---: | ---: | ---: | ---: |\n");
  constexpr double quarter = std::numbers::pi / 2, facet = std::numbers::pi * 10 / 1000;
  measure_whole("half rings 1000 + 1000",
                {half_ring(1000, {1, 0, 0}, -quarter), half_ring(1000, {17, -12, 0}, quarter), 0.25 * facet}, 1000);
  measure_whole("tori 800 + 800", {test::torus_facets(40, {}), test::torus_facets(40, test::stacked()), 1}, 100);
  measure_whole("tori 3200 + 3200", {test::torus_facets(80, {}), test::torus_facets(80, test::stacked()), 0.5}, 100);
}
