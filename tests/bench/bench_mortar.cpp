// SPDX-License-Identifier: Apache-2.0
// Microseconds of one core for the mortar integrals of a pair that overlaps, without and with derivatives, and for the
// rows of two surfaces a segment.
#include <fmt/core.h>

#include <algorithm>
#include <chrono>
#include <limits>

#include "brunt/contact/mortar/tractions.hpp"
#include "unit/contact/mortar/facet_pairs.hpp"
#include "unit/contact/mortar/two_surfaces.hpp"

using namespace brunt;
using namespace brunt::contact;

namespace {

/// Best of several repeats, in microseconds.
template <class Work>
double microseconds(int repeats, const Work& work) {
  using Clock = std::chrono::steady_clock;
  double best = 1e300;
  for (int repeat = 0; repeat < repeats; ++repeat) {
    const Clock::time_point start = Clock::now();
    work();
    best = std::min(best, std::chrono::duration<double, std::micro>(Clock::now() - start).count());
  }
  return best;
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

}  // namespace

int main() {
  fmt::print("{:<28}{:>8}{:>12}{:>8}   [us a segment]\n", "", "values", "derivatives", "ratio");
  measure_pairs("quad on quad", 4, 4);
  measure_pairs("triangle on quad", 3, 4);
  measure_pairs("triangle on triangle", 3, 3);
  measure_rows();
}
