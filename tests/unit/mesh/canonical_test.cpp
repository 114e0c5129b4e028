// SPDX-License-Identifier: Apache-2.0
// The canonical order: a permutation, local, of the mesh alone, exact in its coordinates.
#include "mesh/canonical.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <random>
#include <set>

#include "mesh/topology.hpp"

using namespace brunt;
using namespace brunt::mesh;

namespace {

/// n x n x n unit cells with their foot at `corner`, lexicographic, one spare node that no element uses.
Mesh lattice(LocalIndex n, Vec3 corner) {
  Mesh mesh;
  const auto node = [n](LocalIndex i, LocalIndex j, LocalIndex k) { return i + (n + 1) * (j + (n + 1) * k); };
  for (LocalIndex k = 0; k <= n; ++k)
    for (LocalIndex j = 0; j <= n; ++j)
      for (LocalIndex i = 0; i <= n; ++i) mesh.coordinates.emplace_back(corner + Vec3(i, j, k));
  Block block{"cube", 7, Shape::hex8, {}, {}};
  for (LocalIndex k = 0; k < n; ++k)
    for (LocalIndex j = 0; j < n; ++j)
      for (LocalIndex i = 0; i < n; ++i) {
        for (const auto a :
             {node(i, j, k), node(i + 1, j, k), node(i + 1, j + 1, k), node(i, j + 1, k), node(i, j, k + 1),
              node(i + 1, j, k + 1), node(i + 1, j + 1, k + 1), node(i, j + 1, k + 1)})
          block.nodes.push_back(a);
        block.element_id.push_back(1000 + block.count());
      }
  mesh.blocks.push_back(block);
  mesh.coordinates.insert(mesh.coordinates.begin() + 5, Vec3::Constant(1e9));
  for (auto& a : mesh.blocks[0].nodes)
    if (a >= 5) ++a;
  for (std::size_t a = 0; a < mesh.coordinates.size(); ++a) mesh.node_id.push_back(static_cast<GlobalIndex>(10 * a));
  mesh.node_sets["some"] = {6, 5, 0};
  mesh.side_sets["foot"] = {{0, 3, 4}, {0, 0, 4}, {0, 3, 4}};
  return mesh;
}

}  // namespace

TEST_CASE("on a grid of 2^3 cells consecutive elements along the curve are face neighbours", "[canonical]") {
  for (const LocalIndex n : {2, 4, 8}) {
    const CanonicalMesh c = canonical_order(lattice(n, Vec3::Zero()));
    const Block& block = c.mesh.blocks[0];
    for (LocalIndex e = 1; e < block.count(); ++e) {
      std::set<LocalIndex> before(block.element(e - 1), block.element(e - 1) + 8);
      const auto common =
          std::count_if(block.element(e), block.element(e) + 8, [&](auto a) { return before.count(a); });
      REQUIRE(common == 4);
    }
  }
}

TEST_CASE("elements, ids and sets keep their geometry", "[canonical]") {
  const Mesh input = lattice(3, Vec3(100, -200, 0.25));
  const CanonicalMesh c = canonical_order(Mesh(input));
  REQUIRE(c.mesh.coordinates.size() == input.coordinates.size() - 1);
  REQUIRE(c.input_element[0].size() == 27);
  for (LocalIndex e = 0; e < 27; ++e) {
    const auto old = static_cast<LocalIndex>(c.input_element[0][static_cast<std::size_t>(e)]);
    CHECK(c.mesh.blocks[0].element_id[static_cast<std::size_t>(e)] == 1000 + old + 1);
    for (int k = 0; k < 8; ++k) {
      const auto now = static_cast<std::size_t>(c.mesh.blocks[0].element(e)[k]);
      const auto then = static_cast<std::size_t>(input.blocks[0].element(old)[k]);
      CHECK(c.mesh.coordinates[now] + c.origin == input.coordinates[then]);
      CHECK(c.mesh.node_id[now] == input.node_id[then]);
      CHECK(c.input_node[now] == static_cast<GlobalIndex>(then > 5 ? then - 1 : then));  // positions of the nodes kept
    }
  }
  CHECK(c.mesh.node_sets.at("some").size() == 2);  // the unused node has left
  const auto& sides = c.mesh.side_sets.at("foot");
  REQUIRE(sides.size() == 2);  // the doubled side is there once
  std::set<GlobalIndex> elements;
  for (const Side& s : sides) elements.insert(c.input_element[0][static_cast<std::size_t>(s.element)]);
  CHECK(elements == std::set<GlobalIndex>{0, 3});
}

TEST_CASE("nodes are numbered by first touch", "[canonical]") {
  const CanonicalMesh c = canonical_order(lattice(4, Vec3::Zero()));
  LocalIndex next = 0;
  for (const LocalIndex node : c.mesh.blocks[0].nodes) {
    REQUIRE(node <= next);
    if (node == next) ++next;
  }
  CHECK(next == 125);
}

TEST_CASE("the origin is zero for ordinary coordinates and exact for far ones", "[canonical]") {
  CHECK(canonical_order(lattice(2, Vec3(-3, 10, 0))).origin == Vec3::Zero());
  Mesh far = lattice(2, Vec3(1e6, -3e8, 0));
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> jitter(-0.4, 0.4);
  for (auto& x : far.coordinates) x += Vec3(jitter(random), jitter(random), jitter(random));
  drop_unused_nodes(far);
  const CanonicalMesh c = canonical_order(Mesh(far));
  CHECK(std::abs(c.origin[0] - 1e6) < 8);
  CHECK(std::abs(c.origin[1] + 3e8) < 8);
  CHECK(c.origin[2] == 0);
  for (std::size_t a = 0; a < c.mesh.coordinates.size(); ++a) {
    const Vec3& input = far.coordinates[static_cast<std::size_t>(c.input_node[a])];
    CHECK(c.mesh.coordinates[a] + c.origin == input);
    for (int i = 0; i < 3; ++i) {  // exact also in extended precision
      const long double difference = static_cast<long double>(input[i]) - static_cast<long double>(c.origin[i]);
      CHECK(static_cast<long double>(c.mesh.coordinates[a][i]) == difference);
    }
  }
}
