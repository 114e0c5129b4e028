// SPDX-License-Identifier: Apache-2.0
// Starts from samples of the contact space (depth/samples.hpp) against marches (depth/starts.hpp): mean excess above
// the best known value, and CPU time of a query, over random queries of four pairs. Prints CSV for tests/pictures.
// Usage: bench_depth_samples [QUERIES]
#include <fmt/core.h>

#include <algorithm>
#include <cstdlib>
#include <ctime>
#include <limits>
#include <map>
#include <string>

#include "depth/penetration_depth.hpp"
#include "depth/samples.hpp"
#include "depth/walk.hpp"
#include "tests/support/depth_bodies.hpp"

using namespace brunt;
using test::pi;

namespace {

constexpr std::size_t counts[] = {1, 2, 5, 10, 20};  // K
constexpr std::size_t samples_of[] = {100, 1000, 10000};

/// Of the process: other programs do not count.
double cpu_ms() {
  return 1e3 * static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

struct Pair {
  const char* name;
  TriangleSurface a, b;
  bool fits = false;  ///< queries near the fit instead of anywhere
};

/// A pin in its bore with a clearance of .02, shifted by up to .05 and tilted by up to 1 degree.
Placement near_fit(std::mt19937_64& random) {
  std::uniform_real_distribution<double> any(-1, 1);
  Placement pose;
  const double tilt = pi / 180 * any(random), about = pi * any(random);
  const Vec3 axis(std::cos(about), std::sin(about), 0);
  pose.rotation = Eigen::AngleAxisd(tilt, axis).toRotationMatrix() *
                  Eigen::AngleAxisd(pi * any(random), Vec3::UnitZ()).toRotationMatrix();
  pose.translation = {0.05 * any(random), 0.05 * any(random), 0.5 * any(random)};
  return pose;
}

struct Result {
  std::vector<double> length, ms;
};

/// At most k starts that differ by a tenth of their length, the shortest first.
std::vector<depth::Start> spaced(const depth::Body& a, depth::Metric metric, std::vector<depth::Start> starts,
                                 std::size_t k) {
  std::ranges::sort(starts, {}, &depth::Start::length);
  std::vector<depth::Start> chosen;
  for (const depth::Start& start : starts) {
    const auto near = [&](const depth::Start& other) {
      const depth::RigidMotion between{(other.motion.turn * start.motion.turn.conjugate()).normalized(),
                                       other.motion.shift - start.motion.shift};
      return depth::length_of(a.shape, metric, between) < 0.1 * start.length;
    };
    if (chosen.size() < k && std::ranges::none_of(chosen, near)) chosen.push_back(start);
  }
  return chosen;
}

std::vector<depth::Start> marches(depth::Encounter& encounter, depth::Metric metric) {
  depth::StartOptions options;
  options.metric = metric;
  return depth::find_starts(encounter, options);
}

/// The rounds of walks of depth/samples.cpp from any starts. Infinite: no start is free.
double walked(depth::Encounter& encounter, depth::Metric metric, const std::vector<depth::Start>& starts) {
  depth::WalkOptions options;
  options.metric = metric;
  depth::Walker walker;
  std::vector<depth::Walk> walks;
  for (const depth::Start& start : starts)
    if (const depth::Start free = depth::freed(encounter, metric, start.motion); free.length > 0)
      walks.push_back(depth::Walker::begin(encounter, free.motion, options));
  if (walks.empty()) return std::numeric_limits<double>::infinity();
  for (const auto& [share, steps] : {std::pair<std::size_t, int>{1, 3}, {3, 6}, {10, 40}}) {
    std::ranges::sort(walks, {}, &depth::Walk::length);
    for (std::size_t i = 0; i < (walks.size() + share - 1) / share; ++i)
      walker.advance(encounter, walks[i], options, steps);
  }
  return std::ranges::min(walks, {}, &depth::Walk::length).length;
}

/// Random overlapping placements.
std::vector<Placement> queries_of(const Pair& pair, const depth::Body& a, const depth::Body& b, int count) {
  std::mt19937_64 random(23);
  std::vector<Placement> poses;
  while (static_cast<int>(poses.size()) < count) {
    const Placement pose = pair.fits ? near_fit(random) : test::random_placement(pair.a, pair.b, random);
    if (geometry::surfaces_cross(a.tree, b.tree, pose)) poses.push_back(depth::rounded(pose, a.shape.radius));
  }
  return poses;
}

void measure(const Pair& pair, int queries) {
  const depth::Body a = depth::make_body(pair.a), b = depth::make_body(pair.b);
  const double before_samples = cpu_ms();
  const std::vector<Placement> samples = depth::sample_contacts(a, b, samples_of[2]);
  fmt::print(stderr, "{}: {} samples in {:.0f} ms\n", pair.name, samples.size(), cpu_ms() - before_samples);
  const std::vector<Placement> poses = queries_of(pair, a, b, queries);
  for (const auto& [metric_of, name] :
       {std::pair{depth::Metric::displacement, "DISP"}, {depth::Metric::object_norm, "rms"}}) {
    const depth::Metric metric = metric_of;
    std::map<std::pair<std::string, std::size_t>, Result> results;
    std::vector<double> best;
    for (const Placement& pose : poses) {
      depth::Query query;
      query.a_in_b = pose;
      query.metric = metric;
      query.careful = true;
      best.push_back(depth::penetration_depth(a, b, query).depth);
      const auto tried = [&](const std::string& method, std::size_t k, const auto& search) {
        depth::Encounter encounter{a, b, pose};
        const double before = cpu_ms();
        const double length = search(encounter);
        Result& result = results[{method, k}];
        result.ms.push_back(cpu_ms() - before);
        result.length.push_back(length);
        best.back() = std::min(best.back(), length);
      };
      for (const std::size_t k : counts) {
        for (const std::size_t n : samples_of) {
          const std::vector<Placement> some(samples.begin(), samples.begin() + static_cast<std::ptrdiff_t>(n));
          tried(fmt::format("samples {}", n), k, [&](depth::Encounter& encounter) {
            return walked(encounter, metric, depth::nearest_samples(encounter, metric, some, {k, 0.1}));
          });
        }
        tried("marches", k, [&](depth::Encounter& encounter) {
          return walked(encounter, metric, spaced(a, metric, marches(encounter, metric), k));
        });
        tried("both", k, [&](depth::Encounter& encounter) {
          std::vector<depth::Start> starts = marches(encounter, metric);
          for (const depth::Start& start : depth::nearest_samples(encounter, metric, samples, {k, 0.1}))
            starts.push_back(start);
          return walked(encounter, metric, spaced(a, metric, starts, k));
        });
      }
    }
    for (const auto& [key, result] : results) {
      double excess = 0, ms = 0, far = 0;
      for (std::size_t q = 0; q < best.size(); ++q) {
        const double here = std::min(10.0, result.length[q] / best[q] - 1);  // none found counts as ten times
        excess += here / static_cast<double>(best.size());
        far += (here > 0.05 ? 1.0 : 0.0) / static_cast<double>(best.size());
        ms += result.ms[q] / static_cast<double>(best.size());
      }
      fmt::print("{},{},{},{},{:.6g},{:.6g},{:.6g}\n", pair.name, name, key.first, key.second, excess, far, ms);
      std::fflush(stdout);
    }
  }
}

}  // namespace

int main(int count, char** arguments) {
  const int queries = count > 1 ? std::atoi(arguments[1]) : 100;
  fmt::print("pair,metric,starts,k,excess,above_5_percent,ms\n");
  measure({"L / knot", test::l_shape(), test::knot()}, queries);
  measure({"pawn / hub", test::pawn(), test::hub()}, queries);
  measure({"mallet / bumpy sphere", test::mallet(), test::bumpy_sphere()}, queries);
  const auto ring = [](double radius) {
    return std::vector<std::array<double, 2>>{{radius, -1}, {2, -1}, {2, 1}, {radius, 1}};
  };
  const auto circle = [](double radius) {
    std::vector<std::array<double, 2>> points;
    for (int i = 0; i < 32; ++i) points.push_back({radius * std::cos(pi * i / 16), radius * std::sin(pi * i / 16)});
    return points;
  };
  measure({"pin / bore", test::prism(circle(0.97), -1.5, 1.5), test::revolved(ring(1), 32), true}, queries);
}
