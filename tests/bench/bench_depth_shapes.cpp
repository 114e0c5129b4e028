// SPDX-License-Identifier: Apache-2.0
// What the queries below penetration depth cost: microseconds of processor time for the three pairs of bodies of
// tests/support/depth_bodies.hpp at random placements. Usage: bench_depth_shapes [directions], default 3.
#include <fmt/core.h>

#include <algorithm>
#include <cstdlib>
#include <ctime>
#include <vector>

#include "geometry/triangles/slab_tree.hpp"
#include "support/depth_bodies.hpp"

using namespace brunt;
using geometry::NearPair;
using geometry::SlabTree;

namespace {

/// Waiting for a processor that others use does not count.
double processor_microseconds() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return 1e6 * static_cast<double>(now.tv_sec) + 1e-3 * static_cast<double>(now.tv_nsec);
}

struct Cost {
  std::vector<double> times;
  template <class Work>
  void add(const Work& work) {
    double least = 1e300;
    for (int repeat = 0; repeat < 3; ++repeat) {
      const double start = processor_microseconds();
      work();
      least = std::min(least, processor_microseconds() - start);
    }
    times.push_back(least);
  }
  [[nodiscard]] std::string text() {
    if (times.empty()) return "-";
    std::sort(times.begin(), times.end());
    double sum = 0;
    for (const double t : times) sum += t;
    return fmt::format("{:.1f}, {:.1f}, {:.1f}", sum / static_cast<double>(times.size()), times[times.size() / 2],
                       times[times.size() * 9 / 10]);
  }
};

struct Bodies {
  const char* name;
  TriangleSurface a, b;
};

/// Just free: pushed outwards by bisection from a placement that crosses, then by 1e-6 of the size.
Placement made_free(const SlabTree& a, const SlabTree& b, const Placement& from, double size, std::mt19937& random) {
  const Vec3 direction = test::uniform_rotation(random) * Vec3::UnitX();
  const auto at = [&](double shift) {
    Placement placement = from;
    placement.translation += shift * direction;
    return placement;
  };
  double low = 0, high = 4 * size + a.box.high.norm() + b.box.high.norm();
  while (high - low > 1e-7 * size) {
    const double middle = 0.5 * (low + high);
    (surfaces_cross(a, b, at(middle)) ? low : high) = middle;
  }
  return at(high + 1e-6 * size);
}

void measure(const Bodies& bodies, int directions) {
  const auto more = geometry::more_directions(directions);
  Cost build, crossing, apart, near, distance, depth, depth_near, above;
  SlabTree a, b;
  build.add([&] { b = geometry::build_slab_tree(bodies.b, more); });
  a = geometry::build_slab_tree(bodies.a, more);
  const double size = (a.box.high - a.box.low).norm();
  std::mt19937 random(7);
  std::vector<NearPair> pairs;
  double count = 0;
  for (int k = 0; k < 300; ++k) {
    const Placement placement = test::random_placement(bodies.a, bodies.b, random);
    const bool cross = surfaces_cross(a, b, placement);
    (cross ? crossing : apart).add([&] { surfaces_cross(a, b, placement); });
    if (!cross) continue;
    const Placement free = made_free(a, b, placement, size, random);
    near.add([&] { near_pairs(a, b, free, 0.02 * size, pairs); });
    count += static_cast<double>(pairs.size());
    distance.add([&] { surface_distance(a, b, free); });
  }
  std::vector<Vec3> points;
  const Vec3 middle = 0.5 * (b.box.low + b.box.high), half = 0.5 * (b.box.high - b.box.low);
  std::uniform_real_distribution<double> share(-1, 1);
  for (int k = 0; k < 1000; ++k)
    points.push_back(middle + half.cwiseProduct(Vec3(share(random), share(random), share(random))));
  double sum = 0;
  for (int k = 0; k < 20; ++k) {
    depth.add([&] {
      for (const Vec3& x : points) sum += point_depth(b, x).depth / 1000;
    });
    depth_near.add([&] {
      for (const Vec3& x : points) sum += point_depth(b, x, 0.1 * half.norm()).depth / 1000;
    });
    above.add([&] {
      for (const Vec3& x : points) sum += depth_above(b, x, 0.05 * half.norm()) > 0 ? 1 : 0;
    });
  }
  fmt::print("| {} | {} | {} | {} | {} | {:.0f} | {} | {} | {} | {} |\n", bodies.name, build.text(), crossing.text(),
             apart.text(), near.text(), count / static_cast<double>(near.times.size()), distance.text(), depth.text(),
             depth_near.text(), above.text());
  if (sum == 0.123) fmt::print("\n");  // the sum is used
}

}  // namespace

int main(int argc, char** argv) {
  const int directions = argc > 1 ? std::atoi(argv[1]) : 3;
  fmt::print("Microseconds: mean, median, 90 %. Depths: of 1000 points in the box of b.\n");
  fmt::print(
      "| a / b | build b | crossing | apart | near pairs | pairs | distance | depth | depth within .1 | depth above "
      ".05 |\n");
  fmt::print("|---|---:|---:|---:|---:|---:|---:|---:|---:|---:|\n");
  for (const Bodies& bodies :
       {Bodies{"L / knot", test::l_shape(), test::knot()}, Bodies{"pawn / hub", test::pawn(), test::hub()},
        Bodies{"mallet / bumpy sphere", test::mallet(), test::bumpy_sphere()}})
    measure(bodies, directions);
  return 0;
}
