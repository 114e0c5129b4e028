// SPDX-License-Identifier: Apache-2.0
// The patch test of R. H. MacNeal, R. L. Harder, Finite Elements in Analysis and Design 1 (1985) 3: a unit cube of
// seven distorted hexahedra; a linear displacement of all nodes must give one stress everywhere and leave the inner
// nodes without force. Small-strain values; E = 1e6, nu = 0.25, stress 2000 (normal) and 400 (shear) for a strain of
// 1e-3.
#include <algorithm>
#include <catch2/catch.hpp>
#include <numeric>

#include "mesh/topology.hpp"
#include "support/simulation.hpp"

using namespace brunt;
using test::Simulation;

namespace {

constexpr double corners[16][3] = {{0.249, 0.342, 0.192},
                                   {0.826, 0.288, 0.288},
                                   {0.850, 0.649, 0.263},
                                   {0.273, 0.750, 0.230},
                                   {0.320, 0.186, 0.643},
                                   {0.677, 0.305, 0.683},
                                   {0.788, 0.693, 0.644},
                                   {0.165, 0.745, 0.702},  // inner nodes, then the cube's
                                   {0, 0, 0},
                                   {1, 0, 0},
                                   {1, 1, 0},
                                   {0, 1, 0},
                                   {0, 0, 1},
                                   {1, 0, 1},
                                   {1, 1, 1},
                                   {0, 1, 1}};
constexpr int hexes[7][8] = {{0, 1, 2, 3, 4, 5, 6, 7},   {8, 9, 10, 11, 0, 1, 2, 3},   {4, 5, 6, 7, 12, 13, 14, 15},
                             {8, 9, 1, 0, 12, 13, 5, 4}, {3, 2, 10, 11, 7, 6, 14, 15}, {8, 0, 3, 11, 12, 4, 7, 15},
                             {1, 9, 10, 2, 5, 13, 14, 6}};

mesh::Mesh hexahedra() {
  mesh::Mesh mesh;
  for (const auto& x : corners) mesh.coordinates.emplace_back(x[0], x[1], x[2]);
  mesh::Block block;
  block.name = "patch";
  for (const auto& hex : hexes) block.nodes.insert(block.nodes.end(), std::begin(hex), std::end(hex));
  mesh.blocks.push_back(std::move(block));
  return mesh;
}

/// Twelve tetrahedra a hexahedron: its faces cut through their first node, a node in its middle.
mesh::Mesh tetrahedra() {
  mesh::Mesh mesh = hexahedra();
  mesh::Block block;
  block.name = "patch";
  block.shape = mesh::Shape::tet4;
  for (const auto& hex : hexes) {
    const auto middle = static_cast<LocalIndex>(mesh.coordinates.size());
    Vec3 centre = Vec3::Zero();
    for (const int node : hex) centre += mesh.coordinates[static_cast<std::size_t>(node)] / 8;
    mesh.coordinates.push_back(centre);
    for (int face = 0; face < 6; ++face) {
      std::array<LocalIndex, 4> n = mesh::face_nodes(mesh::Shape::hex8, hex, face);
      std::rotate(n.begin(), std::min_element(n.begin(), n.end()), n.end());
      block.nodes.insert(block.nodes.end(), {n[0], n[2], n[1], middle, n[0], n[3], n[2], middle});
    }
  }
  mesh.blocks[0] = std::move(block);
  return mesh;
}

mesh::Mesh numbered(mesh::Mesh mesh) {
  mesh.node_id.resize(mesh.coordinates.size());
  std::iota(mesh.node_id.begin(), mesh.node_id.end(), 1);
  mesh.blocks[0].element_id.resize(static_cast<std::size_t>(mesh.blocks[0].count()));
  std::iota(mesh.blocks[0].element_id.begin(), mesh.blocks[0].element_id.end(), 1);
  return mesh;
}

Vec3 linear(const Vec3& X) {
  return 0.5e-3 * Vec3(2 * X[0] + X[1] + X[2], X[0] + 2 * X[1] + X[2], X[0] + X[1] + 2 * X[2]);
}

struct Patch {
  std::string element, law;
  int points;

  [[nodiscard]] Simulation displaced(double scale) const {
    const mesh::Mesh mesh = numbered(element == "tet4" ? tetrahedra() : hexahedra());
    Simulation patch(mesh, "materials: {m: {model: " + law + ", density: 1, young: 1.0e6, poisson: 0.25}}\n" +
                               "parts: {patch: {material: m, element: " + element + "}}\n");
    std::vector<Vec3> u;
    for (const Vec3& X : mesh.coordinates) u.push_back(scale * linear(X));
    patch.displace(u, 1e6);  // slowly: no bulk viscosity to speak of
    return patch;
  }
};

bool is_outer(const Vec3& X) {
  return (X.array() == 0).any() || (X.array() == 1).any();
}

const Patch patches[] = {{"hex8", "elastic", 1},          {"hex8", "neo_hookean", 1},  {"hex8_full", "elastic", 8},
                         {"hex8_full", "neo_hookean", 8}, {"hex8_bbar", "elastic", 8}, {"hex8_bbar", "neo_hookean", 8},
                         {"tet4", "elastic", 1},          {"tet4", "neo_hookean", 1}};

}  // namespace

TEST_CASE("patch test: one stress in all elements, no force on inner nodes", "[law]") {
  for (const Patch& kind : patches) {
    CAPTURE(kind.element, kind.law);
    const Simulation patch = kind.displaced(1);
    const model::ElementBlock& block = patch.model.blocks[0];
    for (LocalIndex e = 0; e < block.count; ++e)
      for (int c = 0; c < 6 * kind.points; ++c) {
        const double stress = patch.history(0, "stress", e, c);
        CHECK(std::abs(stress - patch.history(0, "stress", 0, c % 6)) < 1e-12 * 1e6);  // of the modulus
        CHECK(stress ==
              Approx(c % 6 < 3 ? 2000 : 400).epsilon(5e-3));  // finite strain: Cauchy stress of rubber is less by 1/J
      }
    double inner = 0, outer = 0;
    for (LocalIndex i = 0; i < patch.nodes(); ++i) {
      double& largest = is_outer(patch.model.mesh.coordinates[static_cast<std::size_t>(i)]) ? outer : inner;
      largest = std::max(largest, patch.force(i).norm());
    }
    CHECK(inner < 1e-12 * 1e6);
    CHECK(outer > 100);
  }
}

TEST_CASE("patch test: the printed level of stress in the limit of small strain", "[oracle]") {
  for (const Patch& kind : patches) {
    CAPTURE(kind.element, kind.law);
    const Simulation patch = kind.displaced(1e-6);
    for (LocalIndex e = 0; e < patch.model.blocks[0].count; ++e)
      for (int c = 0; c < 6 * kind.points; ++c)
        CHECK(patch.history(0, "stress", e, c) == Approx(c % 6 < 3 ? 2000e-6 : 400e-6).epsilon(1e-5));
  }
}
