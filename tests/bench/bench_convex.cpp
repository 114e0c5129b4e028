// SPDX-License-Identifier: Apache-2.0
// Penetration depth of random convex pairs, ours beside libccd's and FCL's: the largest relative error against the
// Minkowski difference, and the median time of interleaved runs. Then the collision query of three pairs of meshes.
// Usage: bench_convex [PAIRS]. The exit code is 1 if ours errs or collisions differ.
#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <ctime>
#include <string>

#include "convex_peers.hpp"
#include "depth/penetration_depth.hpp"
#include "tests/support/random_polytopes.hpp"

using namespace brunt;
using namespace brunt::bench;

namespace {

constexpr int runs = 9;        // interleaved
constexpr int bodies = 40;     // of 6 to 10 corners: all differences of corners are tried
constexpr double ours = 1e-6;  // greatest relative error of ours (reference A1)

double cpu_us() {
  return 1e6 * static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

double median(std::vector<double> v) {
  std::sort(v.begin(), v.end());
  return v[v.size() / 2];
}

ConvexScene random_scene(int pairs) {
  test::Random random(5);
  ConvexScene scene;
  for (int k = 0; k < bodies; ++k) scene.bodies.push_back(test::random_polytope(random, 6 + random.below(5)));
  while (static_cast<int>(scene.pairs.size()) < pairs) {
    ConvexScene::Pair pair{static_cast<std::size_t>(random.below(bodies)),
                           static_cast<std::size_t>(random.below(bodies)), test::near_placement(random)};
    pair.exact = test::minkowski_depth(scene.bodies[pair.a].points, scene.bodies[pair.b].points, pair.a_in_b);
    if (pair.exact > 1e-3) scene.pairs.push_back(pair);
  }
  return scene;
}

ConvexDepths our_pieces(const ConvexScene& scene) {
  std::vector<depth::ConvexPiece> pieces;
  for (const TriangleSurface& body : scene.bodies) pieces.push_back(depth::convex_piece(body.points));
  return [&scene, pieces](std::span<double> depths) {
    for (std::size_t k = 0; k < depths.size(); ++k) {
      const ConvexScene::Pair& pair = scene.pairs[k];
      depths[k] = depth::translation_depth(pieces[pair.a], pieces[pair.b], pair.a_in_b);
    }
  };
}

/// The whole query: walks, final contact, bound; for convex and other bodies alike.
ConvexDepths our_queries(const ConvexScene& scene, depth::Metric metric) {
  std::vector<depth::Body> prepared;
  for (const TriangleSurface& body : scene.bodies) prepared.push_back(depth::make_body(body));
  return [&scene, prepared, metric](std::span<double> depths) {
    for (std::size_t k = 0; k < depths.size(); ++k) {
      const ConvexScene::Pair& pair = scene.pairs[k];
      depth::Query query;
      query.a_in_b = pair.a_in_b;
      query.metric = metric;
      depths[k] = depth::penetration_depth(prepared[pair.a], prepared[pair.b], query).depth;
    }
  };
}

struct Method {
  std::string name;
  ConvexDepths depths;
  std::vector<double> us{};
  std::vector<double> found{};
};

/// Relative errors of one method; the largest.
double print(const Method& method, const ConvexScene& scene) {
  std::vector<double> errors;
  int missed = 0;
  for (std::size_t k = 0; k < scene.pairs.size(); ++k) {
    if (std::isfinite(method.found[k]))
      errors.push_back(std::abs(method.found[k] / scene.pairs[k].exact - 1));
    else
      ++missed;
  }
  std::sort(errors.begin(), errors.end());
  const auto at = [&](double q) {
    return errors[static_cast<std::size_t>(q * static_cast<double>(errors.size() - 1))];
  };
  fmt::print("| {:38} | {:8.2f} | {:8.1e} | {:8.1e} | {:8.1e} | {:6} |\n", method.name, median(method.us), at(.5),
             at(.99), at(1), missed);
  return missed > 0 ? 1 : at(1);
}

bool compare_convex(int pairs) {
  const ConvexScene scene = random_scene(pairs);
  std::vector<Method> methods{{"Brunt, separating axes", our_pieces(scene)},
                              {"Brunt, whole query, PDt", our_queries(scene, depth::Metric::translation)},
                              {"Brunt, whole query, DISP", our_queries(scene, depth::Metric::displacement)}};
#ifdef BRUNT_WITH_CCD
  methods.push_back({"libccd GJK/EPA, 1e-4 (default)", ccd_epa(scene, 1e-4)});
  methods.push_back({"libccd GJK/EPA, 1e-9", ccd_epa(scene, 1e-9)});
  methods.push_back({"libccd MPR, 1e-4 (default)", ccd_mpr(scene, 1e-4)});
  methods.push_back({"libccd MPR, 1e-9", ccd_mpr(scene, 1e-9)});
#endif
#ifdef BRUNT_WITH_FCL
  methods.push_back({"FCL collide, libccd, 1e-6 (default)", fcl_convex(scene, true, 1e-6)});
  methods.push_back({"FCL collide, own GJK/EPA, 1e-6", fcl_convex(scene, false, 1e-6)});
#endif
  for (Method& method : methods) method.found.resize(scene.pairs.size());
  for (int run = 0; run < runs; ++run)
    for (Method& method : methods) {
      const double before = cpu_us();
      method.depths(method.found);
      method.us.push_back((cpu_us() - before) / static_cast<double>(scene.pairs.size()));
    }
  fmt::print("{} random convex pairs, {} runs\n", scene.pairs.size(), runs);
  fmt::print("| {:38} | {:>8} | {:>8} | {:>8} | {:>8} | {:>6} |\n", "method", "us", "median", "99 %", "largest",
             "missed");
  bool sound = true;
  for (std::size_t m = 0; m < methods.size(); ++m) {
    const double largest = print(methods[m], scene);
    sound = sound && (m > 0 || largest < ours);
  }
  return sound;
}

bool compare_meshes(const char* name, const TriangleSurface& a, const TriangleSurface& b) {
  MeshScene scene{a, b, {}};
  std::mt19937_64 random(13);
  for (int k = 0; k < 300; ++k) scene.placements.push_back(test::random_placement(a, b, random, 1.2));
  const geometry::SlabTree tree_a = geometry::build_slab_tree(a), tree_b = geometry::build_slab_tree(b);
  std::vector<char> found(scene.placements.size()), others(scene.placements.size());
  std::vector<double> us, us_others;
#ifdef BRUNT_WITH_FCL
  const MeshCollisions peer = fcl_meshes(scene);
#endif
  for (int run = 0; run < runs; ++run) {
    double before = cpu_us();
    for (std::size_t k = 0; k < found.size(); ++k)
      found[k] = geometry::surfaces_cross(tree_a, tree_b, scene.placements[k]) ? 1 : 0;
    us.push_back((cpu_us() - before) / static_cast<double>(found.size()));
#ifdef BRUNT_WITH_FCL
    before = cpu_us();
    peer(others);
    us_others.push_back((cpu_us() - before) / static_cast<double>(found.size()));
#endif
  }
  const auto crossing = std::count(found.begin(), found.end(), 1);
  fmt::print("{:22} {} of {} cross: Brunt {:.2f} us", name, crossing, found.size(), median(us));
  if (us_others.empty()) {
    fmt::print("\n");
    return true;
  }
  std::size_t differ = 0;
  for (std::size_t k = 0; k < found.size(); ++k) differ += found[k] != others[k] ? 1U : 0U;
  fmt::print(", FCL {:.2f} us, different answers {}\n", median(us_others), differ);
  return differ == 0;
}

}  // namespace

int main(int count, char** arguments) {
  bool sound = compare_convex(count > 1 ? std::atoi(arguments[1]) : 1000);
  sound = compare_meshes("L / knot", test::l_shape(), test::knot()) && sound;
  sound = compare_meshes("pawn / hub", test::pawn(), test::hub()) && sound;
  sound = compare_meshes("mallet / bumpy sphere", test::mallet(), test::bumpy_sphere()) && sound;
  return sound ? 0 : 1;
}
