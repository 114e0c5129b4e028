// SPDX-License-Identifier: Apache-2.0
// Generated bodies against solid geometry: volume, closed surfaces, area and place of the named sets.
#include "mesh/primitives.hpp"

#include <Eigen/Geometry>
#include <catch2/catch.hpp>
#include <cmath>
#include <map>
#include <numbers>

#include "core/error.hpp"
#include "mesh/check.hpp"
#include "mesh/topology.hpp"

using namespace brunt;
using namespace brunt::mesh;
using std::numbers::pi;

namespace {

const Vec3& at(const Mesh& mesh, LocalIndex node) {
  return mesh.coordinates[static_cast<std::size_t>(node)];
}

/// Vector area of a (possibly bilinear) quadrilateral: half the cross product of its diagonals.
Vec3 vector_area(const Mesh& mesh, const Side& side) {
  const auto n = face_nodes(Shape::hex8, mesh.blocks[0].element(side.element), side.face);
  return 0.5 * (at(mesh, n[2]) - at(mesh, n[0])).cross(at(mesh, n[3]) - at(mesh, n[1]));
}

Vec3 face_centre(const Mesh& mesh, const Side& side) {
  const auto n = face_nodes(Shape::hex8, mesh.blocks[0].element(side.element), side.face);
  return 0.25 * (at(mesh, n[0]) + at(mesh, n[1]) + at(mesh, n[2]) + at(mesh, n[3]));
}

/// Divergence theorem over the exterior; exact for plane faces, of second order else.
double enclosed_volume(const Mesh& mesh) {
  double volume = 0;
  for (const Side& side : exterior_sides(mesh)) volume += face_centre(mesh, side).dot(vector_area(mesh, side)) / 3;
  return volume;
}

double area(const Mesh& mesh, const std::string& set) {
  double sum = 0;
  for (const Side& side : mesh.side_sets.at(set)) sum += vector_area(mesh, side).norm();
  return sum;
}

/// Every edge of the exterior belongs to exactly two of its faces.
bool closed(const Mesh& mesh) {
  std::map<std::pair<LocalIndex, LocalIndex>, int> faces_at;
  for (const Side& side : exterior_sides(mesh)) {
    const auto n = face_nodes(Shape::hex8, mesh.blocks[0].element(side.element), side.face);
    for (std::size_t k = 0; k < 4; ++k) ++faces_at[std::minmax(n[k], n[(k + 1) % 4])];
  }
  return std::all_of(faces_at.begin(), faces_at.end(), [](const auto& entry) { return entry.second == 2; });
}

void require_sound(const Mesh& mesh) {
  const CheckReport report = check(mesh);
  CHECK(report.faults == std::vector<std::string>{});
  CHECK(report.warnings == std::vector<std::string>{});
  CHECK(closed(mesh));
}

}  // namespace

TEST_CASE("a box is numbered lexicographically", "[primitives]") {
  const Mesh mesh = box("b", {2, 3, 4}, {2, 3, 5});
  require_sound(mesh);
  CHECK(mesh.blocks[0].name == "b");
  CHECK(mesh.blocks[0].count() == 30);
  CHECK(at(mesh, 1) == Vec3(1, 0, 0));
  CHECK(at(mesh, 3) == Vec3(0, 1, 0));
  CHECK(at(mesh, 12) == Vec3(0, 0, 0.8));
  CHECK(mesh.coordinates.back() == Vec3(2, 3, 4));
  CHECK(std::vector(mesh.blocks[0].element(1), mesh.blocks[0].element(2)) ==
        std::vector<LocalIndex>{1, 2, 5, 4, 13, 14, 17, 16});
  CHECK(enclosed_volume(mesh) == Approx(24));
  CHECK(area(mesh, "b_xmin") == Approx(12));
  CHECK(area(mesh, "b_ymax") == Approx(8));
  CHECK(area(mesh, "b_zmax") == Approx(6));
  for (const LocalIndex n : mesh.node_sets.at("b_ymax")) CHECK(at(mesh, n)[1] == 3);
  CHECK(mesh.node_sets.at("b_ymax").size() == 3 * 6);
}

TEST_CASE("a plate stands on its centre", "[primitives]") {
  const Mesh mesh = plate("p", {2, 4}, 0.5, {4, 4, 1});
  require_sound(mesh);
  CHECK(mesh.coordinates.front() == Vec3(-1, -2, 0));
  CHECK(mesh.coordinates.back() == Vec3(1, 2, 0.5));
  CHECK(area(mesh, "p_zmin") == Approx(8));
  CHECK(mesh.side_sets.at("p_xmax").size() == 4);
}

TEST_CASE("around a cylinder there are as many elements as is told", "[primitives]") {
  for (const int n : {2, 3, 4, 6, 9, 16}) {
    const Mesh mesh = cylinder("c", 2, 3, {n, 4});
    CHECK(mesh.side_sets.at("c_side").size() == static_cast<std::size_t>(4 * elements_around(n)));
  }
  CHECK(elements_around(6) == 32);
}

TEST_CASE("a cylinder's section is a regular polygon", "[primitives]") {
  for (const int n : {2, 3, 5, 8}) {
    const Mesh mesh = cylinder("c", 2, 3, {n, 4});
    require_sound(mesh);
    const double sides = static_cast<double>(mesh.side_sets.at("c_side").size()) / 4;
    CHECK(enclosed_volume(mesh) == Approx(0.5 * sides * 4 * std::sin(2 * pi / sides) * 3).epsilon(1e-12));
    CHECK(area(mesh, "c_side") == Approx(sides * 2 * 2 * std::sin(pi / sides) * 3).epsilon(1e-12));
    CHECK(area(mesh, "c_top") == Approx(area(mesh, "c_bottom")));
    CHECK(mesh.side_sets.at("c_top").size() * 4 == static_cast<std::size_t>(mesh.blocks[0].count()));
    for (const LocalIndex node : mesh.node_sets.at("c_side"))
      CHECK(at(mesh, node).head<2>().norm() == Approx(2).epsilon(1e-14));
  }
}

TEST_CASE("a tube has two round surfaces", "[primitives]") {
  const Mesh mesh = tube("t", 1, 2, 3, {2, 12, 3});
  require_sound(mesh);
  CHECK(enclosed_volume(mesh) == Approx(0.5 * 12 * (4 - 1) * std::sin(2 * pi / 12) * 3));
  CHECK(mesh.side_sets.at("t_inner").size() == 36);
  CHECK(mesh.side_sets.at("t_side").size() == 36);
  CHECK(area(mesh, "t_inner") == Approx(12 * 2 * std::sin(pi / 12) * 3));
  for (const LocalIndex node : mesh.node_sets.at("t_inner"))
    CHECK(at(mesh, node).head<2>().norm() == Approx(1).epsilon(1e-14));
}

TEST_CASE("a sphere's volume and surface converge with the square of the element size", "[primitives]") {
  const auto volume_error = [](int n) {
    return 1 - enclosed_volume(sphere("s", 1.5, n)) / (4.0 / 3 * pi * 1.5 * 1.5 * 1.5);
  };
  for (const int n : {2, 3, 4, 7}) {
    const Mesh mesh = sphere("s", 1.5, n);
    require_sound(mesh);
    CHECK(mesh.side_sets.at("s_surface").size() == exterior_sides(mesh).size());
    for (const LocalIndex node : mesh.node_sets.at("s_surface"))
      CHECK(at(mesh, node).norm() == Approx(1.5).epsilon(1e-14));
    Vec3 centroid = Vec3::Zero();
    for (const Vec3& x : mesh.coordinates) centroid += x;
    CHECK(centroid.norm() < 1e-10);
  }
  CHECK(volume_error(5) > 0);
  CHECK(volume_error(5) / volume_error(10) == Approx(4).epsilon(0.1));
}

TEST_CASE("a half sphere is half of the whole one, its planes are sets", "[primitives]") {
  const Mesh whole = sphere("s", 2, 4);
  const Mesh quarter = sphere("s", 2, 4, {.half = {1, 1, 0}});
  require_sound(quarter);
  CHECK(4 * quarter.blocks[0].count() == whole.blocks[0].count());
  CHECK(enclosed_volume(quarter) == Approx(enclosed_volume(whole) / 4).epsilon(1e-12));
  CHECK(area(quarter, "s_surface") == Approx(area(whole, "s_surface") / 4).epsilon(1e-12));
  for (const LocalIndex node : quarter.node_sets.at("s_ymin")) CHECK(at(quarter, node)[1] == 0);
  const std::size_t sides = quarter.side_sets.at("s_surface").size() + 2 * quarter.side_sets.at("s_xmin").size();
  CHECK(sides == exterior_sides(quarter).size());
  CHECK(quarter.node_sets.count("s_zmin") == 0);
}

TEST_CASE("a sphere made finer at its foot keeps its surface and the shapes of its elements", "[primitives]") {
  const double finer = 5;
  struct Stretch {
    double smallest = 1e9, largest = 0, uneven = 0;  // of edges; uneven: greatest over least within an element
  };
  const auto stretch = [&](int n) {
    const Mesh even = sphere("s", 2, n), graded = sphere("s", 2, n, {.finer = finer});
    require_sound(graded);
    CHECK(graded.blocks[0].nodes == even.blocks[0].nodes);
    for (const LocalIndex node : graded.node_sets.at("s_surface"))
      CHECK(at(graded, node).norm() == Approx(2).epsilon(1e-14));
    Stretch found;
    for (LocalIndex e = 0; e < even.blocks[0].count(); ++e) {
      double low = 1e9, high = 0;
      for (const auto& [a, b] :
           {std::pair{0, 1}, {1, 2}, {2, 3}, {3, 0}, {4, 5}, {5, 6}, {6, 7}, {7, 4}, {0, 4}, {1, 5}, {2, 6}, {3, 7}}) {
        const LocalIndex i = even.blocks[0].element(e)[a], j = even.blocks[0].element(e)[b];
        const double ratio = (at(graded, i) - at(graded, j)).norm() / (at(even, i) - at(even, j)).norm();
        low = std::min(low, ratio);
        high = std::max(high, ratio);
      }
      found = {std::min(found.smallest, low), std::max(found.largest, high), std::max(found.uneven, high / low - 1)};
    }
    return found;
  };
  const Stretch coarse = stretch(8), fine = stretch(16);
  CHECK(fine.smallest == Approx(1 / finer).epsilon(0.05));
  CHECK(fine.largest < finer);
  CHECK(fine.largest > 0.7 * finer);         // the few elements at the top are large
  CHECK(fine.uneven < 0.6 * coarse.uneven);  // conformal: none in the limit
}

TEST_CASE("wrong parameters are named, all at once", "[primitives]") {
  try {
    tube("t", 2, 1, -3, {0, 12, 3});
    FAIL("accepted");
  } catch (const InputError& error) {
    REQUIRE(error.faults().size() == 3);
    CHECK(error.faults()[0] == "tube t: out of range: inner_radius is 2; expected less than outer_radius 1");
    CHECK(error.faults()[1] == "tube t: out of range: length is -3; expected a number > 0");
    CHECK(error.faults()[2] == "tube t: out of range: elements through the wall is 0; expected at least 1");
  }
  CHECK_THROWS_AS(box("b", {1, NAN, 1}, {1, 1, 1}), InputError);
  CHECK_THROWS_AS(box("b", {1, 1, 1}, {2000, 2000, 2000}), InputError);
  CHECK_THROWS_AS(cylinder("c", 1, 1, {1, 1}), InputError);
  CHECK_THROWS_AS(sphere("s", 1, 1), InputError);
  CHECK_THROWS_AS(sphere("s", 1, 4, {.finer = 0.5}), InputError);
  CHECK_THROWS_AS(sphere("s", 1, 4, {.finer = 2, .half = {0, 0, 1}}), InputError);
}
