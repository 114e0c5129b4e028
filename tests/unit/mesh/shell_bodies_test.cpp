// SPDX-License-Identifier: Apache-2.0
// Generated bodies of shells against geometry: areas, normals, shared edges, sets, triangles.
#include "mesh/shell_bodies.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <map>
#include <numbers>
#include <set>

#include "core/error.hpp"
#include "mesh/check.hpp"
#include "mesh/mixed_normals.hpp"
#include "mesh/topology.hpp"

using namespace brunt;
using namespace brunt::mesh;
using std::numbers::pi;

namespace {

const Vec3& at(const Mesh& mesh, LocalIndex node) {
  return nth(mesh.coordinates, node);
}

struct Face {
  Vec3 area, centre;
};

/// Half the cross product of the diagonals, or of two edges of a triangle.
Face face_of(const Mesh& mesh, const Side& side) {
  const Block& block = nth(mesh.blocks, side.block);
  const auto n = face_nodes(block.shape, block.element(side.element), side.face);
  if (n[3] == no_index)
    return {0.5 * (at(mesh, n[1]) - at(mesh, n[0])).cross(at(mesh, n[2]) - at(mesh, n[0])),
            (at(mesh, n[0]) + at(mesh, n[1]) + at(mesh, n[2])) / 3};
  return {0.5 * (at(mesh, n[2]) - at(mesh, n[0])).cross(at(mesh, n[3]) - at(mesh, n[1])),
          0.25 * (at(mesh, n[0]) + at(mesh, n[1]) + at(mesh, n[2]) + at(mesh, n[3]))};
}

double area(const Mesh& mesh, const std::vector<Side>& sides) {
  double sum = 0;
  for (const Side& side : sides) sum += face_of(mesh, side).area.norm();
  return sum;
}

double area(const Mesh& mesh) {
  return area(mesh, exterior_sides(mesh));
}

/// Edges of one element alone: those of an opening.
std::size_t open_edges(const Mesh& mesh) {
  std::map<std::pair<LocalIndex, LocalIndex>, int> uses;
  for (const Block& block : mesh.blocks)
    for (LocalIndex e = 0; e < block.count(); ++e)
      for (const auto& [a, b] : cells::of(block.shape).edges)
        ++uses[std::minmax(block.element(e)[a], block.element(e)[b])];
  return static_cast<std::size_t>(std::ranges::count_if(uses, [](const auto& use) { return use.second == 1; }));
}

void require_sound(const Mesh& mesh) {
  const CheckReport report = check(mesh);
  CHECK(report.faults.empty());
  CHECK(report.warnings.empty());                                                          // among them mixed normals
  CHECK(exterior_sides(mesh).size() == static_cast<std::size_t>(mesh.blocks[0].count()));  // each shell once
}

/// Nodes of a set at which `holds(x)`; all of them must.
template <class Holds>
std::size_t counted(const Mesh& mesh, const std::string& set, Holds holds) {
  for (const LocalIndex n : mesh.node_sets.at(set)) CHECK(holds(at(mesh, n)));
  return mesh.node_sets.at(set).size();
}

}  // namespace

TEST_CASE("a plate of shells") {
  const Mesh mesh = shell_plate("p", {4, 2}, {8, 6});
  require_sound(mesh);
  CHECK(mesh.blocks[0].count() == 48);
  CHECK(mesh.coordinates.size() == 9 * 7);
  CHECK(area(mesh) == Approx(8).epsilon(1e-14));
  for (const Side& side : exterior_sides(mesh)) CHECK(face_of(mesh, side).area[2] > 0);
  CHECK(counted(mesh, "p_xmin", [](const Vec3& x) { return x[0] == -2; }) == 7);
  CHECK(counted(mesh, "p_xmax", [](const Vec3& x) { return x[0] == 2; }) == 7);
  CHECK(counted(mesh, "p_ymin", [](const Vec3& x) { return x[1] == -1; }) == 9);
  CHECK(counted(mesh, "p_ymax", [](const Vec3& x) { return x[1] == 1; }) == 9);
  CHECK_FALSE(mesh.side_sets.contains("p_xmin"));
  for (const Side& side : mesh.side_sets.at("p_zmax")) CHECK(face_of(mesh, side).area[2] > 0);
  for (const Side& side : mesh.side_sets.at("p_zmin")) CHECK(face_of(mesh, side).area[2] < 0);
  CHECK(area(mesh, mesh.side_sets.at("p_zmin")) == Approx(8).epsilon(1e-14));
}

TEST_CASE("a graded plate of shells") {
  Divisions<2> elements(2, 1);
  elements[0].bias = 3;
  const Mesh mesh = shell_plate("p", {4, 2}, elements);
  CHECK(at(mesh, 1)[0] == Approx(-1));  // elements of 1 and 3
}

TEST_CASE("a tube of shells") {
  const double radius = 20, length = 50;
  const Mesh mesh = shell_tube("t", radius, length, {24, 5});
  require_sound(mesh);
  CHECK(open_edges(mesh) == 48);  // its two ends
  CHECK(area(mesh) == Approx(24 * 2 * radius * std::sin(pi / 24) * length).epsilon(1e-12));
  for (const Side& side : exterior_sides(mesh)) {
    const Face face = face_of(mesh, side);
    CHECK(face.area.normalized().dot(Vec3(face.centre[0], face.centre[1], 0).normalized()) == Approx(1));
  }
  CHECK(counted(mesh, "t_bottom", [](const Vec3& x) { return x[2] == 0; }) == 24);
  CHECK(counted(mesh, "t_top", [&](const Vec3& x) { return x[2] == length; }) == 24);
  for (const Side& side : mesh.side_sets.at("t_inner")) {
    const Face face = face_of(mesh, side);
    CHECK(face.area.dot(Vec3(face.centre[0], face.centre[1], 0)) < 0);
  }
}

TEST_CASE("a quarter and a sector of a tube of shells") {
  const Mesh quarter = shell_tube("t", 2, 1, {24, 2}, {1, 1, 0});
  require_sound(quarter);
  CHECK(quarter.blocks[0].count() == 12);
  CHECK(counted(quarter, "t_xmin", [](const Vec3& x) { return x[0] == 0; }) == 3);
  CHECK(counted(quarter, "t_ymin", [](const Vec3& x) { return x[1] == 0; }) == 3);
  RoundForm form;
  form.sector = {30, 90};
  const Mesh sector = shell_tube("t", 2, 1, {6, 2}, form);
  require_sound(sector);
  CHECK(sector.blocks[0].count() == 12);
  CHECK(counted(sector, "t_from", [](const Vec3& x) { return std::abs(x[1] - 1) < 1e-14; }) == 3);
  CHECK(counted(sector, "t_to", [](const Vec3& x) { return std::abs(x[0]) < 1e-14; }) == 3);
}

TEST_CASE("a box of shells") {
  const Mesh mesh = shell_box("b", Vec3(2, 3, 4), {2, 3, 4});
  require_sound(mesh);
  CHECK(open_edges(mesh) == 0);
  CHECK(mesh.blocks[0].count() == 2 * (6 + 12 + 8));
  CHECK(mesh.coordinates.size() == 3 * 4 * 5 - 1 * 2 * 3);  // all nodes of the grid but the inner ones
  double volume = 0;
  for (const Side& side : exterior_sides(mesh)) volume += face_of(mesh, side).area.dot(face_of(mesh, side).centre) / 3;
  CHECK(volume == Approx(24).epsilon(1e-13));  // normals outwards
  CHECK(counted(mesh, "b_zmax", [](const Vec3& x) { return x[2] == 4; }) == 12);
  CHECK(area(mesh, mesh.side_sets.at("b_ymin")) == Approx(8));
  for (const Side& side : mesh.side_sets.at("b_ymin")) CHECK(face_of(mesh, side).area[1] < 0);

  const Mesh can = shell_box("b", Vec3(2, 3, 4), {2, 3, 4}, {false, false, false, false, false, true});
  require_sound(can);
  CHECK(open_edges(can) == 10);
  CHECK(counted(can, "b_zmax", [](const Vec3& x) { return x[2] == 4; }) == 10);  // its rim
  CHECK_FALSE(can.side_sets.contains("b_zmax"));
  CHECK_THROWS_AS(shell_box("b", Vec3(1, 1, 1), {1, 1, 1}, {true, true, true, true, true, true}), InputError);
}

TEST_CASE("a sphere of shells") {
  const Mesh mesh = shell_sphere("s", 3, 10);
  require_sound(mesh);
  CHECK(open_edges(mesh) == 0);
  for (const Vec3& x : mesh.coordinates) CHECK(x.norm() == Approx(3));
  CHECK(area(mesh) == Approx(4 * pi * 9).epsilon(0.01));
  for (const Side& side : exterior_sides(mesh)) CHECK(face_of(mesh, side).area.dot(face_of(mesh, side).centre) > 0);
  CHECK(mesh.side_sets.at("s_surface").size() == static_cast<std::size_t>(mesh.blocks[0].count()));
  CHECK(elements_around(10) == 4 * static_cast<int>(std::lround(std::sqrt(mesh.blocks[0].count() / 6.0))));

  const Mesh half = shell_sphere("s", 3, 10, {2, {0, 0, -1}});
  require_sound(half);
  CHECK(2 * half.blocks[0].count() == mesh.blocks[0].count());
  CHECK(counted(half, "s_zmax", [](const Vec3& x) { return std::abs(x[2]) < 1e-14; }) == open_edges(half));
}

TEST_CASE("triangles of generated quadrilaterals") {
  Mesh mesh = shell_box("b", Vec3(2, 3, 4), {2, 3, 4});
  const std::size_t sides = mesh.side_sets.at("b_xmin").size();
  const double before = area(mesh, mesh.side_sets.at("b_xmin"));
  split_into_triangles(mesh);
  require_sound(mesh);
  CHECK(mesh.blocks[0].shape == Shape::tri3);
  CHECK(mesh.blocks[0].count() == 2 * 52);
  CHECK(open_edges(mesh) == 0);
  CHECK(mesh.side_sets.at("b_xmin").size() == 2 * sides);
  CHECK(area(mesh, mesh.side_sets.at("b_xmin")) == Approx(before));

  Mesh plate = shell_plate("p", {4, 4}, {4, 4});  // diagonals of neighbours alternate: they meet in every second node
  split_into_triangles(plate);
  std::map<LocalIndex, int> triangles;
  for (const LocalIndex n : plate.blocks[0].nodes) ++triangles[n];
  for (LocalIndex n = 0; n < 25; ++n) {
    const int i = n % 5, j = n / 5;
    if (i > 0 && i < 4 && j > 0 && j < 4) CHECK(triangles[n] == ((i + j) % 2 == 0 ? 8 : 4));
  }
}

TEST_CASE("mixed normals of shells are counted") {
  Mesh mesh = shell_plate("p", {3, 1}, {3, 1});
  CHECK(mixed_normals(mesh.blocks[0]).count == 0);
  std::swap(mesh.blocks[0].nodes[5], mesh.blocks[0].nodes[7]);  // the element in the middle
  const MixedNormals mixed = mixed_normals(mesh.blocks[0]);
  CHECK(mixed.count == 2);
  CHECK(std::set{mixed.first, mixed.second} == std::set{0, 1});
  const CheckReport report = check(mesh);
  REQUIRE(report.warnings.size() == 1);
  CHECK_THAT(report.warnings[0], Catch::Contains("block p: the normals of its shells are mixed: 2 edges"));
}

TEST_CASE("a shell on a solid is the exterior there, between two solids it is not") {
  Mesh mesh = box("b", Vec3(1, 1, 2), {1, 1, 2});
  Block& skin = mesh.blocks.emplace_back(Block{"skin", 2, Shape::quad4, {8, 9, 11, 10}, {1}});
  const auto of_skin = [&] {
    const auto sides = exterior_sides(mesh);
    return std::ranges::count(sides, 1, &Side::block);
  };
  CHECK(exterior_sides(mesh).size() == 10);  // the face of the solid below it is covered
  CHECK(of_skin() == 1);
  skin.nodes = {4, 5, 7, 6};
  CHECK(of_skin() == 0);
}

TEST_CASE("shapes of shells that are refused") {
  const auto fault_of = [](Mesh mesh) {
    const CheckReport report = check(mesh);
    return report.faults.empty() ? std::string() : report.faults.front();
  };
  Mesh mesh = shell_plate("p", {1, 1}, {1, 1});
  CHECK(fault_of(mesh).empty());
  Mesh folded = mesh;
  folded.coordinates[3] = Vec3(-0.4, -0.4, 0);  // the corner lies beyond the diagonal
  CHECK_THAT(fault_of(folded), Catch::Contains("element 1 (block p): the Jacobian at node"));
  Mesh repeated = mesh;
  repeated.blocks[0].nodes[3] = repeated.blocks[0].nodes[2];
  CHECK_THAT(fault_of(repeated), Catch::Contains("repeated nodes; expected four different nodes"));
}
