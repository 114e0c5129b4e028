// SPDX-License-Identifier: Apache-2.0
// Measured times become weights that sum to them, rank by rank.
#include "partition/measured.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <vector>

#include "mesh/canonical.hpp"
#include "partition/dual_graph.hpp"
#include "unit/partition/meshes.hpp"

using namespace brunt;
using partition::Weights;

TEST_CASE("measured: a rank's time is shared by usual cost and by pairs") {
  const Weights usual{{1, 1, 5, 1}, {3, 0, 0, 2}};
  const std::vector<double> element{2, 6}, contact{0.5, 1.5}, pairs{0, 4, 3, 1};
  const std::vector<Rank> rank{0, 0, 1, 1};
  const Weights weights = weigh(usual, {element, contact, rank, pairs});
  CHECK(weights.cost[0] == Approx(0.5));  // 1 s of 8 s in four elements, whose mean is 2 s
  CHECK(weights.cost[1] == Approx(0.5));
  CHECK(weights.cost[2] == Approx(2.5));
  CHECK(weights.cost[3] == Approx(0.5));
  // 0.5 s, 1.125 s and 0.375 s of contact, whose mean is 2/3 s
  CHECK(weights.contact_faces == std::vector<std::int32_t>{0, 750, 1688, 563});
}

TEST_CASE("measured: without times the usual cost stays, without pairs contact weighs nothing") {
  const Weights usual{{1, 2}, {1, 1}};
  const std::vector<double> none{0, 0}, some{1, 1}, pairs{0, 0};
  const std::vector<Rank> rank{0, 1};
  CHECK(weigh(usual, {none, some, rank, pairs}).cost == usual.cost);
  CHECK(weigh(usual, {some, some, rank, pairs}).contact_faces == std::vector<std::int32_t>{0, 0});
  CHECK_THROWS(weigh(usual, {some, some, std::vector<Rank>{0}, pairs}));
}

TEST_CASE("measured: contact that sits at one end is dealt out to all parts") {
  const mesh::Mesh mesh = mesh::canonical_order(partition::test::box({32, 8, 8})).mesh;
  const Ragged<LocalIndex> graph = partition::dual_graph(mesh);
  const Weights usual = partition::weigh(mesh, {});
  std::vector<Rank> rank;
  std::vector<double> pairs;
  partition::for_each_element(mesh, [&](std::span<const LocalIndex> nodes, mesh::Shape) {
    const double x = mesh.coordinates[static_cast<std::size_t>(nodes[0])][0];
    rank.push_back(x < 16 ? 0 : 1);
    pairs.push_back(x < 4 ? 10 : 0);
  });
  const std::vector<double> element_seconds{1, 1}, contact_seconds{1, 0};
  const Weights weights = weigh(usual, {element_seconds, contact_seconds, rank, pairs});
  const std::vector<Rank> part = partition::split(graph, weights, 2);
  double contact[2] = {0, 0}, cost[2] = {0, 0};
  for (std::size_t e = 0; e < part.size(); ++e) {
    contact[part[e]] += weights.contact_faces[e];
    cost[part[e]] += weights.cost[e];
  }
  CHECK(std::max(contact[0], contact[1]) <= 1.05 * 0.5 * (contact[0] + contact[1]));
  CHECK(std::max(cost[0], cost[1]) <= 1.01 * 0.5 * (cost[0] + cost[1]));
}
