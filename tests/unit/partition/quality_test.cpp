// SPDX-License-Identifier: Apache-2.0
// The figures of a split, counted by hand on a row of four hexes.
#include "partition/quality.hpp"

#include <catch2/catch.hpp>
#include <vector>

#include "mesh/topology.hpp"
#include "partition/dual_graph.hpp"
#include "unit/partition/meshes.hpp"

using namespace brunt;

namespace {

partition::Quality of(const std::vector<Rank>& part, int parts) {
  const mesh::Mesh row = partition::test::box({4, 1, 1});
  return partition::quality(row, partition::dual_graph(row), partition::weigh(row, mesh::exterior_sides(row)), part,
                            parts);
}

}  // namespace

TEST_CASE("two halves of a row of four") {
  const partition::Quality q = of({0, 0, 1, 1}, 2);
  CHECK(q.elements == 4);
  CHECK(q.contact_faces == 18);  // 5 + 4 + 4 + 5
  CHECK(q.element_imbalance == 1.0);
  CHECK(q.contact_imbalance == 1.0);
  CHECK(q.edge_cut == 1);
  CHECK(q.shared_nodes == 4);
  CHECK(q.corner_forces == 8);  // of two elements at each of four nodes
  CHECK(q.neighbours_max == 1);
  CHECK(q.neighbours_mean == 1.0);
  CHECK(q.empty_parts == 0);
}

TEST_CASE("a quarter, a half and a quarter, and one part with nothing") {
  const partition::Quality q = of({0, 1, 1, 3}, 4);
  CHECK(q.element_imbalance == 2.0);  // 2 where 1 is the mean
  CHECK(q.contact_imbalance == Approx(8.0 / (18.0 / 4.0)));
  CHECK(q.edge_cut == 2);
  CHECK(q.shared_nodes == 8);
  CHECK(q.corner_forces == 16);
  CHECK(q.neighbours_max == 2);
  CHECK(q.neighbours_mean == 1.0);  // 1 + 2 + 0 + 1 over 4
  CHECK(q.empty_parts == 1);
}

TEST_CASE("one part shares nothing") {
  const partition::Quality q = of({0, 0, 0, 0}, 1);
  CHECK(q.element_imbalance == 1.0);
  CHECK(q.edge_cut == 0);
  CHECK(q.shared_nodes == 0);
  CHECK(q.corner_forces == 0);
  CHECK(q.neighbours_max == 0);
}
