// SPDX-License-Identifier: Apache-2.0
// Splits are balanced, repeatable, and exist for any number of parts.
#include "partition/split.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <set>
#include <vector>

#include "mesh/canonical.hpp"
#include "mesh/topology.hpp"
#include "partition/dual_graph.hpp"
#include "partition/quality.hpp"
#include "unit/partition/meshes.hpp"

using namespace brunt;
using partition::split;

namespace {

partition::Quality quality_of(const mesh::Mesh& mesh, int parts) {
  return partition::quality(mesh, partition::dual_graph(mesh), partition::weigh(mesh, mesh::exterior_sides(mesh)),
                            split(mesh, parts), parts);
}

}  // namespace

TEST_CASE("a box of 20^3 hexes is balanced in elements and in contact faces") {
  const mesh::Mesh mesh = mesh::canonical_order(partition::test::box({20, 20, 20})).mesh;
  for (const int parts : {2, 3, 4, 7}) {
    const partition::Quality q = quality_of(mesh, parts);
    CAPTURE(parts, q.element_imbalance, q.contact_imbalance, q.edge_cut);
    CHECK(q.element_imbalance <= 1.05);
    CHECK(q.contact_imbalance <= 1.05);
    CHECK(q.empty_parts == 0);
    CHECK(q.contact_faces == 6 * 400);
    // no cut of a cube into halves is smaller than a plane; METIS stays below `parts` planes
    CHECK(q.edge_cut >= 400);
    CHECK(q.edge_cut <= 400 * parts);
  }
}

TEST_CASE("a split is the same every time") {
  const mesh::Mesh mesh = partition::test::box({8, 8, 8});
  CHECK(split(mesh, 5) == split(mesh, 5));
}

TEST_CASE("every number of parts works, more parts than elements too") {
  const mesh::Mesh mesh = partition::test::box({3, 2, 2});
  for (int parts = 1; parts <= 15; ++parts) {
    const std::vector<Rank> part = split(mesh, parts);
    REQUIRE(part.size() == 12);
    const std::set<Rank> used(part.begin(), part.end());
    CHECK(used.size() == static_cast<std::size_t>(std::min(parts, 12)));
    CHECK(*used.begin() >= 0);
    CHECK(*used.rbegin() < parts);
  }
  CHECK_THROWS(split(mesh, 0));
}

TEST_CASE("elements that share nothing are split evenly") {
  mesh::Mesh mesh;
  for (int i = 0; i < 64; ++i) partition::test::add_box(mesh, {1, 1, 1}, 2.0 * i, mesh::Shape::hex8, "");
  const partition::Quality q = quality_of(mesh, 4);
  CHECK(q.element_imbalance <= 1.13);  // 18 of 16
  CHECK(q.empty_parts == 0);
  CHECK(q.edge_cut == 0);
  CHECK(q.shared_nodes == 0);
}

TEST_CASE("bodies apart from each other, hexes and tets, are balanced by cost") {
  mesh::Mesh mesh;
  partition::test::add_box(mesh, {10, 10, 10}, 0.0, mesh::Shape::hex8, "hexes");
  partition::test::add_box(mesh, {7, 7, 7}, 20.0, mesh::Shape::tet4, "tets");
  for (const int parts : {2, 3, 4}) {
    const partition::Quality q = quality_of(mesh, parts);
    CAPTURE(parts, q.contact_imbalance);
    CHECK(q.element_imbalance <= 1.05);
    CHECK(q.contact_imbalance <= 1.05);
  }
}

TEST_CASE("without contact faces the cost alone is balanced") {
  const mesh::Mesh mesh = partition::test::box({10, 10, 4});
  const std::vector<double> cost{3.0e7};
  const partition::Weights weights = partition::weigh(mesh, {}, cost);
  CHECK(weights.cost[0] == 3.0e7);
  const auto graph = partition::dual_graph(mesh);
  const partition::Quality q = partition::quality(mesh, graph, weights, split(graph, weights, 4), 4);
  CHECK(q.contact_faces == 0);
  CHECK(q.contact_imbalance == 1.0);
  CHECK(q.element_imbalance <= 1.05);
}

TEST_CASE("elements of very different cost share the work") {
  mesh::Mesh mesh;
  partition::test::add_box(mesh, {10, 10, 5}, 0.0, mesh::Shape::hex8, "cheap");
  partition::test::add_box(mesh, {10, 10, 5}, 20.0, mesh::Shape::hex8, "dear");
  const std::vector<double> cost{1.0, 9.0};
  const auto weights = partition::weigh(mesh, mesh::exterior_sides(mesh), cost);
  const auto graph = partition::dual_graph(mesh);
  const partition::Quality q = partition::quality(mesh, graph, weights, split(graph, weights, 2), 2);
  CHECK(q.element_imbalance <= 1.05);
  CHECK_THROWS(partition::weigh(mesh, {}, std::vector<double>{1.0}));
}
