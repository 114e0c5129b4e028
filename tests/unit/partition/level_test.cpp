// SPDX-License-Identifier: Apache-2.0
// What METIS leaves uneven is levelled at the borders.
#include "partition/level.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <vector>

#include "mesh/canonical.hpp"
#include "mesh/topology.hpp"
#include "partition/dual_graph.hpp"
#include "partition/quality.hpp"
#include "unit/partition/meshes.hpp"

using namespace brunt;

namespace {

struct Scene {
  mesh::Mesh mesh;
  Ragged<LocalIndex> graph = partition::dual_graph(mesh);
  partition::Weights weights = partition::weigh(mesh, {});

  [[nodiscard]] partition::Quality quality(const std::vector<Rank>& part, int parts) const {
    return partition::quality(mesh, graph, weights, part, parts);
  }
};

/// Part p is the slice of i < ends[p].
std::vector<Rank> slices(int n, const std::vector<int>& ends) {
  std::vector<Rank> part;
  for (int e = 0; e < n * n * n; ++e)
    part.push_back(static_cast<Rank>(std::ranges::upper_bound(ends, e % n) - ends.begin()));
  return part;
}

}  // namespace

TEST_CASE("a layer too much goes over, and the border stays a plane") {
  const Scene scene{partition::test::box({10, 10, 10})};
  std::vector<Rank> part = slices(10, {6, 10});
  partition::level(scene.graph, scene.weights, 2, 0.0, part);
  const partition::Quality q = scene.quality(part, 2);
  CHECK(q.element_imbalance == 1.0);
  CHECK(q.edge_cut == 100);
}

TEST_CASE("load passes on through a part between") {
  const Scene scene{partition::test::box({12, 12, 12})};
  std::vector<Rank> part = slices(12, {6, 10, 12});
  partition::level(scene.graph, scene.weights, 3, 0.001, part);
  const partition::Quality q = scene.quality(part, 3);
  CHECK(q.element_imbalance <= 1.004);  // two elements of 576
  CHECK(q.edge_cut <= 3 * 144);
}

TEST_CASE("what is level stays as it is, and what shares no face cannot move") {
  const Scene scene{partition::test::box({8, 8, 8})};
  const std::vector<Rank> even = slices(8, {4, 8});
  std::vector<Rank> part = even;
  partition::level(scene.graph, scene.weights, 2, 0.0, part);
  CHECK(part == even);

  mesh::Mesh apart = partition::test::box({4, 4, 4});
  partition::test::add_box(apart, {2, 2, 2}, 20.0, mesh::Shape::hex8, "other");
  const Scene two{std::move(apart)};
  std::vector<Rank> bodies(64, 0);
  bodies.resize(72, 1);
  const std::vector<Rank> before = bodies;
  partition::level(two.graph, two.weights, 2, 0.0, bodies);
  CHECK(bodies == before);
}

TEST_CASE("contact faces stay spread") {
  Scene scene{partition::test::box({10, 10, 10})};
  // all of them in the layers that would go over
  for (std::size_t e = 0; e < 1000; ++e) scene.weights.contact_faces[e] = e % 10 >= 5 ? 1 : 0;
  std::vector<Rank> part = slices(10, {6, 10});
  const GlobalIndex most = 400;
  partition::level(scene.graph, scene.weights, 2, 0.0, part);
  GlobalIndex faces = 0;
  for (std::size_t e = 0; e < 1000; ++e) faces += part[e] == 1 ? scene.weights.contact_faces[e] : 0;
  CHECK(faces <= most);
}

TEST_CASE("METIS and levelling together stay within a thousandth") {
  const mesh::Mesh mesh = mesh::canonical_order(partition::test::box({20, 20, 20})).mesh;
  const Ragged<LocalIndex> graph = partition::dual_graph(mesh);
  const partition::Weights weights = partition::weigh(mesh, mesh::exterior_sides(mesh));
  for (const int parts : {2, 3, 5, 8}) {
    const std::vector<Rank> part = partition::split(graph, weights, parts);
    const partition::Quality q = partition::quality(mesh, graph, weights, part, parts);
    CAPTURE(parts, q.contact_imbalance, q.edge_cut);
    CHECK(q.element_imbalance <= 1.0 + 0.0005 + 2 * parts / 8000.0);  // two elements: the border's have contact faces
    CHECK(q.contact_imbalance <= 1.021);
    CHECK(part == partition::split(graph, weights, parts));
  }
}

TEST_CASE("a border of steps becomes shorter, within the load allowed, and the same each time") {
  const Scene scene{partition::test::box({12, 12, 12})};
  std::vector<Rank> part;  // steps of single elements on a plane
  for (int e = 0; e < 12 * 12 * 12; ++e) {
    const int i = e % 12, j = e / 12 % 12, k = e / 144;
    part.push_back(i < 6 || (i == 6 && j % 4 == 1 && k % 4 == 2) ? 0 : 1);
  }
  const GlobalIndex before = scene.quality(part, 2).edge_cut;
  std::vector<Rank> again = part;
  partition::smooth(scene.graph, scene.weights, 2, 0.01, part);
  const partition::Quality q = scene.quality(part, 2);
  CHECK(before == 144 + 4 * 9);
  CHECK(q.edge_cut == 144);
  CHECK(q.element_imbalance <= 1.01);
  partition::smooth(scene.graph, scene.weights, 2, 0.01, again);
  CHECK(again == part);
}
