// SPDX-License-Identifier: Apache-2.0
// CPU time of penetration depth queries, lower bound included: median and 99 % over random poses of three pairs.
// Usage: bench_depth [POSES]
#include <fmt/core.h>

#include <algorithm>
#include <cstdlib>
#include <ctime>

#include "depth/penetration_depth.hpp"
#include "tests/support/depth_bodies.hpp"

using namespace brunt;

namespace {

/// Of the process: other programs do not count.
double cpu_ms() {
  return 1e3 * static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

double quantile(std::vector<double> v, double q) {
  std::sort(v.begin(), v.end());
  return v[static_cast<std::size_t>(q * static_cast<double>(v.size() - 1))];
}

struct Pair {
  const char* name;
  TriangleSurface a, b;
};

void measure(const Pair& pair, int count) {
  const double start = cpu_ms();
  const depth::Body a = depth::make_body(pair.a), b = depth::make_body(pair.b);
  fmt::print("{}: bodies {:.0f} ms\n", pair.name, cpu_ms() - start);
  std::mt19937_64 random(11);
  std::vector<Placement> poses;
  while (static_cast<int>(poses.size()) < count) {
    const Placement pose = test::random_placement(pair.a, pair.b, random);
    if (geometry::surfaces_cross(a.tree, b.tree, pose)) poses.push_back(pose);
  }
  for (const bool careful : {false, true})
    for (const auto& [metric, name] : {std::pair{depth::Metric::translation, "PDt"},
                                       {depth::Metric::displacement, "DISP"},
                                       {depth::Metric::object_norm, "rms"}}) {
      std::vector<double> ms;
      double queries = 0, pairs = 0, steps = 0;
      for (const Placement& pose : poses) {
        depth::Query query;
        query.a_in_b = pose;
        query.metric = metric;
        query.careful = careful;
        const double before = cpu_ms();
        const depth::Answer answer = depth::penetration_depth(a, b, query);
        ms.push_back(cpu_ms() - before);
        queries += static_cast<double>(answer.queries) / count;
        pairs += static_cast<double>(answer.pairs) / count;
        steps += static_cast<double>(answer.steps) / count;
      }
      fmt::print(
          "  {:7} {:4} median {:7.2f} ms, 99 % {:7.2f}, most {:7.2f}; {:.0f} queries, {:.0f} steps, {:.0f} pairs\n",
          careful ? "careful" : "fast", name, quantile(ms, .5), quantile(ms, .99), quantile(ms, 1), queries, steps,
          pairs);
    }
}

}  // namespace

int main(int count, char** arguments) {
  const int poses = count > 1 ? std::atoi(arguments[1]) : 100;
  measure({"L / knot", test::l_shape(), test::knot()}, poses);
  measure({"pawn / hub", test::pawn(), test::hub()}, poses);
  measure({"mallet / bumpy sphere", test::mallet(), test::bumpy_sphere()}, poses);
}
