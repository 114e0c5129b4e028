// SPDX-License-Identifier: Apache-2.0
// Penetration depths against closed forms and best known values with certified bounds; tables of figures.
#include <fmt/core.h>

#include <catch2/catch.hpp>
#include <cstdlib>
#include <ctime>

#include "depth/penetration_depth.hpp"
#include "tests/depth/cases.hpp"
#include "tests/support/depth_bodies.hpp"

using namespace brunt;

namespace {

constexpr std::array<depth::Metric, 3> metrics{depth::Metric::translation, depth::Metric::displacement,
                                               depth::Metric::object_norm};
constexpr std::array<const char*, 3> names{"PDt", "DISP", "rms"};

/// CPU time of the process: other programs do not count.
double cpu_ms() {
  return 1e3 * static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

void print(const test::DepthCase& c, bool careful) {
  const depth::Body a = depth::make_body(c.a.surface, {400, c.a.pieces}),
                    b = depth::make_body(c.b.surface, {400, c.b.pieces});
  fmt::print("{:24}", c.name);
  for (std::size_t m = 0; m < 3; ++m) {
    depth::Query query;
    query.a_in_b = c.a_in_b;
    query.metric = metrics[m];
    query.careful = careful;
    const double before = cpu_ms();
    const depth::Answer answer = depth::penetration_depth(a, b, query);
    const double ms = cpu_ms() - before;
    fmt::print(
        " | {:4} {:.6f} {:+8.4f} % (ref {:.6f}) >= {:.4f} {:2} walks {:3} steps {:5} queries {:6} pairs {:6.1f} ms",
        names[m], answer.depth, c.depth[m] > 0 ? 100 * (answer.depth / c.depth[m] - 1) : 0, c.depth[m], answer.bound,
        answer.walks, answer.steps, answer.queries, answer.pairs, ms);
  }
  fmt::print("\n");
}

}  // namespace

TEST_CASE("careful: closed forms and interlocked boxes", "[oracle]") {
  constexpr double digits = 1.0001;  // of the reference values, the slender box on end has four
  for (const auto& set : {test::closed_forms(), test::interlocked_boxes()})
    for (const test::DepthCase& c : set) {
      const depth::Body a = depth::make_body(c.a.surface, {400, c.a.pieces}),
                        b = depth::make_body(c.b.surface, {400, c.b.pieces});
      for (std::size_t m = 0; m < 3; ++m) {
        if (c.depth[m] == 0) continue;
        depth::Query query;
        query.a_in_b = c.a_in_b;
        query.metric = metrics[m];
        query.careful = true;
        const depth::Answer answer = depth::penetration_depth(a, b, query);
        INFO(c.name << " " << names[m]);
        CHECK(answer.depth <= c.depth[m] * digits);
        CHECK(answer.depth >= c.bound[m]);
        CHECK(answer.bound <= answer.depth);
      }
    }
}

// cases/mesh_pairs asks the program the same
TEST_CASE("careful: fixed poses of the three pairs within 2 % of the best known values in 95 %", "[.][long][oracle]") {
  int all = 0, good = 0;
  for (const test::DepthCase& c : test::mesh_pairs()) {
    const depth::Body a = depth::make_body(c.a.surface), b = depth::make_body(c.b.surface);
    for (std::size_t m = 0; m < 3; ++m) {
      depth::Query query;
      query.a_in_b = c.a_in_b;
      query.metric = metrics[m];
      query.careful = true;
      const depth::Answer answer = depth::penetration_depth(a, b, query);
      ++all;
      good += answer.depth <= 1.02 * c.depth[m];
      CHECK(answer.bound <= answer.depth);
    }
  }
  CHECK(good >= 37);
  CHECK(all == 39);
}

TEST_CASE("table of values", "[.][table]") {
  for (const bool careful : {false, true}) {
    fmt::print("{}\n", careful ? "careful" : "fast");
    for (const auto& set : {test::closed_forms(), test::interlocked_boxes(), test::mesh_pairs()})
      for (const test::DepthCase& c : set) print(c, careful);
  }
}

namespace {

/// Random overlapping poses of a pair.
std::vector<Placement> random_poses(const TriangleSurface& a, const TriangleSurface& b, const depth::Body& body_a,
                                    const depth::Body& body_b, int count) {
  std::mt19937_64 random(7);
  std::vector<Placement> poses;
  while (static_cast<int>(poses.size()) < count) {
    const Placement pose = test::random_placement(a, b, random);
    if (geometry::surfaces_cross(body_a.tree, body_b.tree, pose)) poses.push_back(pose);
  }
  return poses;
}

}  // namespace

TEST_CASE("table of certificates", "[.][table]") {
  const std::int64_t boxes = std::getenv("BOXES") ? std::atoll(std::getenv("BOXES")) : 100000;
  for (const auto& set : {test::closed_forms(), test::interlocked_boxes(), test::mesh_pairs()})
    for (const test::DepthCase& c : set) {
      if (c.name.starts_with("A1")) continue;
      const depth::Body a = depth::make_body(c.a.surface, {400, c.a.pieces}),
                        b = depth::make_body(c.b.surface, {400, c.b.pieces});
      fmt::print("{:24}", c.name);
      for (std::size_t m = 0; m < 3; ++m) {
        depth::Query query;
        query.a_in_b = c.a_in_b;
        query.metric = metrics[m];
        query.boxes = boxes;
        const double before = cpu_ms();
        const depth::Answer answer = depth::penetration_depth(a, b, query);
        fmt::print(" | {:4} {:.6f} {:+8.4f} % >= {:.4f} ({:.4f}) {:7} boxes {:6.0f} ms", names[m], answer.depth,
                   c.depth[m] > 0 ? 100 * (answer.depth / c.depth[m] - 1) : 0, answer.bound, c.bound[m], answer.boxes,
                   cpu_ms() - before);
      }
      fmt::print("\n");
      std::fflush(stdout);
    }
}

TEST_CASE("table of random poses", "[.][table]") {
  const char* pairs[] = {"L/knot", "pawn/hub", "mallet/bumpy"};
  const TriangleSurface as[] = {test::l_shape(), test::pawn(), test::mallet()};
  const TriangleSurface bs[] = {test::knot(), test::hub(), test::bumpy_sphere()};
  const int count = std::getenv("POSES") ? std::atoi(std::getenv("POSES")) : 40;
  for (int p = 0; p < 3; ++p) {
    const depth::Body a = depth::make_body(as[p]), b = depth::make_body(bs[p]);
    const auto poses = random_poses(as[p], bs[p], a, b, count);
    for (std::size_t m = 0; m < 3; ++m) {
      std::array<std::vector<double>, 2> excess, ms;
      for (const Placement& pose : poses) {
        std::array<double, 2> depths{};
        for (const int careful : {0, 1}) {
          depth::Query query;
          query.a_in_b = pose;
          query.metric = metrics[m];
          query.careful = careful == 1;
          const double before = cpu_ms();
          depths[static_cast<std::size_t>(careful)] = depth::penetration_depth(a, b, query).depth;
          ms[static_cast<std::size_t>(careful)].push_back(cpu_ms() - before);
        }
        excess[0].push_back(depths[0] / depths[1] - 1);
      }
      const auto quantile = [](std::vector<double> v, double q) {
        std::sort(v.begin(), v.end());
        return v[static_cast<std::size_t>(q * static_cast<double>(v.size() - 1))];
      };
      double mean = 0;
      int bad = 0;
      for (const double e : excess[0]) {
        mean += 100 * e / count;
        bad += e > .05;
      }
      fmt::print(
          "{:13} {:4} fast/careful mean {:6.2f} % >5%: {:3} of {} | fast ms {:.2f} {:.2f} {:.2f} | careful {:.1f} "
          "{:.1f}\n",
          pairs[p], names[m], mean, bad, count, quantile(ms[0], .5), quantile(ms[0], .99), quantile(ms[0], 1),
          quantile(ms[1], .5), quantile(ms[1], 1));
    }
  }
}
