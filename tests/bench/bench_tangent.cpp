// SPDX-License-Identifier: Apache-2.0
// Nanoseconds of one core for the consistent tangent of an element, beside those for its forces.
#include <fmt/core.h>

#include <algorithm>
#include <chrono>
#include <numeric>

#include "support/element_block.hpp"

using namespace brunt;
using element::ElementKind;

namespace {

/// Best of several repeats, in nanoseconds, of `work` done `count` times.
template <class Work>
double nanoseconds(int count, const Work& work) {
  using Clock = std::chrono::steady_clock;
  double best = 1e300;
  for (int repeat = 0; repeat < 200; ++repeat) {
    const Clock::time_point start = Clock::now();
    for (int i = 0; i < count; ++i) work();
    best = std::min(best, std::chrono::duration<double, std::nano>(Clock::now() - start).count() / count);
  }
  return best;
}

/// Of a small block that stays in cache.
void measure(ElementKind kind, const char* name, const material::Law& law) {
  test::ElementBlockBench bench(kind, law, {4, 4, 4});
  bench.place([](const Vec3& X) { return Vec3(1.01 * X[0], X[1] + 0.02 * X[2], X[2]); }, 1);
  force::History trial = bench.state.history;
  const auto count = static_cast<std::size_t>(bench.block().count),
             corners = static_cast<std::size_t>(bench.block().corners());
  std::vector<LocalIndex> all(count);
  std::iota(all.begin(), all.end(), 0);
  std::vector<double> K(count * 9 * corners * corners);
  const force::Motion motion = bench.motion(false);
  const double forces =
      nanoseconds(20, [&] { force::trial_forces(bench.model, motion, bench.state.history, trial, bench.scratch); });
  const double tangents =
      nanoseconds(1, [&] { force::element_tangents(bench.model, 0, all, motion, bench.state.history, K); });
  const auto elements = static_cast<double>(count);
  fmt::print("{:<12}{:<24}{:8.0f}{:10.0f}\n", element::name_of(kind), name, forces / elements, tangents / elements);
}

}  // namespace

int main() {
  fmt::print("{:<36}{:>8}{:>10}   [ns an element]\n", "", "forces", "tangent");
  for (const ElementKind kind : {ElementKind::hex8_full, ElementKind::hex8_bbar, ElementKind::tet4}) {
    measure(kind, "elastic", material::Elastic{8000, 2e11, 0.3});
    measure(kind, "elastic, logarithmic", material::Elastic{8000, 2e11, 0.3, material::StressRate::logarithmic});
    measure(kind, "J2", material::J2{8000, 2e11, 0.3, 4e8, 1e9, {}, 0});
    measure(kind, "J2, table, mixed", material::J2{8000, 2e11, 0.3, 0, 0, {{0, 4e8}, {0.1, 5e8}}, 0.5});
    measure(kind, "neo-Hookean", material::NeoHookean{1000, 4e6, 1e6});
  }
}
