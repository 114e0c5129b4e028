// SPDX-License-Identifier: Apache-2.0
// Sharp edges, smooth patches and regions of surfaces.
#include "contact/mortar/patches.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>
#include <set>

using namespace brunt;
using namespace brunt::contact;

namespace {

struct Shell {
  std::vector<Vec3> x;
  std::vector<FacetNodes> facets;
};

/// The six sides of a unit cube, one facet each, seen from outside.
Shell cube() {
  Shell cube;
  for (int k = 0; k < 8; ++k) cube.x.emplace_back(k & 1, (k >> 1) & 1, (k >> 2) & 1);
  cube.facets = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
  return cube;
}

/// A strip of quadrilaterals along a circle of `count` facets, seen from outside.
Shell ring(int count) {
  Shell ring;
  for (int k = 0; k < count; ++k)
    for (const double z : {0.0, 1.0}) {
      const double angle = 2 * std::numbers::pi * k / count;
      ring.x.emplace_back(std::cos(angle), std::sin(angle), z);
    }
  for (int k = 0; k < count; ++k) {
    const int a = 2 * k, b = 2 * ((k + 1) % count);
    ring.facets.push_back({a, b, b + 1, a + 1});
  }
  return ring;
}

}  // namespace

TEST_CASE("A corner of a box has three rows, a round surface one for each node") {
  const Shell box = cube();
  const PatchRows rows = patch_rows(box.facets, box.x);
  CHECK(rows.nodes.size() == 24);
  CHECK(std::ranges::is_sorted(rows.nodes));
  std::set<LocalIndex> used;
  for (std::size_t facet = 0; facet < box.facets.size(); ++facet)
    for (std::size_t k = 0; k < 4; ++k) {
      const LocalIndex row = rows.of_corner[facet][k];
      CHECK(rows.nodes[static_cast<std::size_t>(row)] == box.facets[facet][k]);
      used.insert(row);
    }
  CHECK(used.size() == 24);
  const Shell round = ring(8), square = ring(4);
  CHECK(patch_rows(round.facets, round.x).nodes.size() == 16);
  CHECK(patch_rows(square.facets, square.x).nodes.size() == 16);  // two for each of eight
}

TEST_CASE("Only convex edges have sharp nodes") {
  const Shell box = cube();
  CHECK(sharp_nodes(box.facets, box.x).size() == 8);
  Shell hollow = box;  // seen from inside
  for (FacetNodes& facet : hollow.facets) std::swap(facet[1], facet[3]);
  CHECK(sharp_nodes(hollow.facets, hollow.x).empty());
  const Shell round = ring(8);
  CHECK(sharp_nodes(round.facets, round.x).empty());
}

TEST_CASE("A surface ends at convex sharp edges and where it has no neighbour") {
  const Shell box = cube();
  for (const std::uint8_t rims : rims_of(box.facets, box.x)) CHECK(rims == 15);
  Shell inside = box;
  for (FacetNodes& facet : inside.facets) std::swap(facet[1], facet[3]);
  for (const std::uint8_t rims : rims_of(inside.facets, inside.x)) CHECK(rims == 0);
  const Shell round = ring(8);
  for (const std::uint8_t rims : rims_of(round.facets, round.x)) CHECK(rims == 0b0101);
  const std::vector<PatchNumbers> two{{{0, 1, 4, 3}, 0b0001}, {{1, 2, 5, 4}, 0}};
  const NodePatches patches = patches_of(two);
  CHECK(patches.at_rim == std::vector<std::uint8_t>{1, 1, 0, 0, 0, 0});
}

TEST_CASE("Regions that share a node have different colours") {
  const Shell box = cube();
  const std::vector<std::size_t> colours = region_colours(box.facets, box.x);
  CHECK(std::set<std::size_t>(colours.begin(), colours.end()).size() == 3);
  for (std::size_t a = 0; a < 6; ++a)
    for (std::size_t b = 0; b < a; ++b) {
      const bool meet = std::ranges::any_of(box.facets[a], [&](LocalIndex node) {
        return std::ranges::find(box.facets[b], node) != box.facets[b].end();
      });
      CHECK((!meet || colours[a] != colours[b]));
    }
  const Shell round = ring(12);
  CHECK(std::ranges::all_of(region_colours(round.facets, round.x), [](std::size_t colour) { return colour == 0; }));
}

TEST_CASE("A facet without area has no sharp edge") {
  Shell box = cube();
  box.facets.push_back({0, 1, 0, 1});
  CHECK(sharp_nodes(box.facets, box.x).size() == 8);
  const PatchRows rows = patch_rows(box.facets, box.x);
  for (const LocalIndex row : rows.of_corner.back()) CHECK(row >= 0);
}
