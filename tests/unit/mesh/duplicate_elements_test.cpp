// SPDX-License-Identifier: Apache-2.0
// Elements that are there twice, on the same nodes or in the same place, and elements too small for their coordinates.
#include "mesh/duplicate_elements.hpp"

#include <catch2/catch.hpp>

#include "mesh/assemble.hpp"
#include "mesh/check.hpp"
#include "mesh/primitives.hpp"
#include "mesh/resolution.hpp"

using namespace brunt;
using namespace brunt::mesh;

namespace {

/// A second block of the given elements, numbered from 101.
Mesh with_block(Mesh mesh, Shape shape, std::vector<LocalIndex> nodes) {
  Block block{"second", 2, shape, std::move(nodes), {}};
  for (LocalIndex e = 0; e < block.count(); ++e) block.element_id.push_back(101 + e);
  mesh.blocks.push_back(std::move(block));
  return mesh;
}

std::vector<LocalIndex> nodes_of(const Mesh& mesh, LocalIndex e) {
  const LocalIndex* nodes = mesh.blocks[0].element(e);
  return {nodes, nodes + nodes_per_element(mesh.blocks[0].shape)};
}

}  // namespace

TEST_CASE("a duplicate on the same nodes is named with its pair", "[duplicates]") {
  const Mesh plain = box("b", {1, 1, 1}, {2, 3, 2});
  CHECK(duplicate_elements(plain).empty());
  for (const LocalIndex e : {0, 5, 11}) {
    const std::vector<LocalIndex> n = nodes_of(plain, e);
    const std::string pair = " (block second): it has the nodes of element " + std::to_string(e + 1) + " (block b)";
    const std::vector<std::vector<LocalIndex>> orders{
        n, {n[1], n[2], n[3], n[0], n[5], n[6], n[7], n[4]}, {n[4], n[0], n[3], n[7], n[5], n[1], n[2], n[6]}};
    for (const auto& order : orders) {  // as it is, and turned
      const auto faults = check(with_block(plain, Shape::hex8, order)).faults;
      REQUIRE(faults.size() == 1);
      CHECK_THAT(faults[0], Catch::StartsWith("invalid element 101" + pair));
    }
  }
  Mesh same = plain;  // within one block, one of twelve there twice and another three times
  for (const LocalIndex e : {3, 7, 7}) {
    const auto again = nodes_of(plain, e);
    same.blocks[0].nodes.insert(same.blocks[0].nodes.end(), again.begin(), again.end());
    same.blocks[0].element_id.push_back(50 + e);
  }
  CHECK(check(same).faults.size() == 3);
  Mesh doubled = plain;  // all of them: ten lines and how many more
  doubled.blocks[0].nodes.insert(doubled.blocks[0].nodes.end(), plain.blocks[0].nodes.begin(),
                                 plain.blocks[0].nodes.end());
  for (GlobalIndex e = 13; e <= 24; ++e) doubled.blocks[0].element_id.push_back(e);
  CHECK(check(doubled).faults.size() == 11);
}

TEST_CASE("duplicates of wedges, pyramids and tetrahedra, across shapes", "[duplicates]") {
  Mesh mesh = box("b", {1, 1, 1}, {1, 1, 1});
  mesh.coordinates = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}};
  mesh.node_sets.clear();
  mesh.side_sets.clear();
  const auto duplicates = [&](const std::vector<LocalIndex>& a, Shape shape, const std::vector<LocalIndex>& b) {
    mesh.blocks[0].nodes = a;
    return check(with_block(mesh, shape, b)).faults.size();
  };
  CHECK(duplicates({0, 1, 2, 2, 4, 5, 6, 6}, Shape::hex8, {1, 2, 0, 0, 5, 6, 4, 4}) == 1);  // wedges
  CHECK(duplicates({0, 1, 2, 3, 4, 4, 4, 4}, Shape::hex8, {1, 2, 3, 0, 4, 4, 4, 4}) == 1);  // pyramids
  CHECK(duplicates({0, 1, 3, 3, 4, 4, 4, 4}, Shape::tet4, {1, 3, 0, 4}) == 1);
  CHECK(duplicates({0, 1, 2, 2, 4, 5, 6, 6}, Shape::hex8, {0, 2, 3, 3, 4, 6, 7, 7}) ==
        0);  // the other half of the cube
}

TEST_CASE("bodies in the same place are found, wherever and however they stand", "[duplicates]") {
  for (const Vec3& at : {Vec3(0, 0, 0), Vec3(1e6, -3, 7), Vec3(0.1, 0.2, 0.3)})
    for (const double turn : {0.0, 10.0, 90.0})
      for (const int n : {1, 2, 5}) {
        Mesh whole = box("a", {0.3, 0.2, 0.1}, {n, n, n}), other = box("b", {0.3, 0.2, 0.1}, {n, n, n});
        place(whole, 1, {1, 2, 3}, turn, at);
        place(other, 3, {1, 2, 3}, turn, 3 * at);
        place(other, 1.0 / 3, {1, 0, 0}, 0, {0, 0, 0});  // the same place but for rounding
        append(whole, std::move(other));
        const auto lines = coincident_elements(whole, {0, 1});
        REQUIRE(lines.size() == 1);
        CHECK_THAT(lines[0],
                   Catch::StartsWith("invalid block a and block b: " + std::to_string(n * n * n) + " element"));
        CHECK(coincident_elements(whole, {0, 0}).empty());
      }
  // one element of many; and bodies that touch, overlap in part, or lie on finer elements, are none
  const auto found = [](const Vec3& at, const std::array<int, 3>& elements, const Vec3& size) {
    Mesh whole = box("a", {1, 1, 1}, {4, 4, 4}), other = box("b", size, elements);
    place(other, 1, {0, 0, 1}, 0, at);
    append(whole, std::move(other));
    return coincident_elements(whole, {0, 1}).size();
  };
  CHECK(found({0.5, 0.5, 0.5}, {1, 1, 1}, {0.25, 0.25, 0.25}) == 1);
  CHECK(found({0.75, 0, 0}, {4, 4, 4}, {1, 1, 1}) == 1);  // a layer of each
  CHECK(found({1, 0, 0}, {4, 4, 4}, {1, 1, 1}) == 0);
  CHECK(found({0.001, 0, 0}, {4, 4, 4}, {1, 1, 1}) == 0);
  CHECK(found({0, 0, 0}, {5, 5, 5}, {1, 1, 1}) == 0);
}

TEST_CASE("elements too small for their coordinates are a fault", "[duplicates]") {
  for (const double size : {1e-6, 1.0, 1e9}) {
    const Mesh mesh = box("b", {2 * size, size, size}, {2, 1, 1});
    CHECK(resolution_fault(mesh, 0).empty());
    CHECK(resolution_fault(mesh, 1.0e9 * size).empty());
    CHECK_THAT(resolution_fault(mesh, 1.8e10 * size), Catch::Contains("below the rounding"));
    Mesh far = mesh;
    place(far, 1, {0, 0, 1}, 0, {0, 0, 1e15 * size});
    CHECK_THAT(resolution_fault(far, 0), Catch::Contains("(block b)"));
    for (Vec3& x : far.coordinates) x[2] = 1e17 * size;
    CHECK_FALSE(resolution_fault(far, 0).empty());
  }
  for (const double size : {1e-200, 1e200})
    CHECK_FALSE(resolution_fault(box("b", {size, size, size}, {1, 1, 1}), 0).empty());
}
