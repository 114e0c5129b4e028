// SPDX-License-Identifier: Apache-2.0
// Elements along a line: even ones, those that grow, and those of given sizes at places.
#include "mesh/division.hpp"

#include <catch2/catch.hpp>

#include "core/error.hpp"
#include "mesh/check.hpp"
#include "mesh/primitives.hpp"

using namespace brunt;
using namespace brunt::mesh;

namespace {

std::vector<double> sizes_of(const std::vector<double>& ends) {
  std::vector<double> sizes;
  for (std::size_t i = 1; i < ends.size(); ++i) sizes.push_back(ends[i] - ends[i - 1]);
  return sizes;
}

Division with_bias(int cells, double bias) {
  Division division(cells);
  division.bias = bias;
  return division;
}

}  // namespace

TEST_CASE("elements with a bias grow in geometric progression", "[primitives]") {
  for (const double bias : {0.1, 1.0, 8.0}) {
    const std::vector<double> ends = places(with_bias(7, bias), 2, 5), sizes = sizes_of(ends);
    CHECK(ends.front() == 2);
    CHECK(ends.back() == 5);
    CHECK(sizes.back() / sizes.front() == Approx(bias));
    for (std::size_t i = 2; i < sizes.size(); ++i)
      CHECK(sizes[i] * sizes[i - 2] == Approx(sizes[i - 1] * sizes[i - 1]));
  }
  CHECK(places(with_bias(1, 5), 0, 3) == std::vector<double>{0, 3});
}

TEST_CASE("elements have the sizes that are given at places", "[primitives]") {
  const Division division = by_sizes({{6, 1}, {8, 0.5}, {12, 0.5}, {250, 15}}, 0.5, 250);
  const std::vector<double> ends = places(division, 0.5, 250), sizes = sizes_of(ends);
  REQUIRE(static_cast<int>(sizes.size()) == division.cells);
  CHECK(ends.front() == 0.5);
  CHECK(ends.back() == 250);
  for (const double place : {6.0, 8.0, 12.0}) CHECK(std::count(ends.begin(), ends.end(), place) == 1);
  for (std::size_t i = 0; i < sizes.size(); ++i) {
    const double middle = ends[i] + sizes[i] / 2;
    const double wanted = middle < 6    ? 1
                          : middle < 8  ? 1 - 0.25 * (middle - 6)
                          : middle < 12 ? 0.5
                                        : 0.5 + 14.5 * (middle - 12) / 238;
    CHECK(sizes[i] == Approx(wanted).epsilon(0.1));  // a whole number of elements between places
    if (i > 0) CHECK(sizes[i] / sizes[i - 1] == Approx(1).margin(0.3));
  }
  CHECK(cells_below(division, 0.5, 12) == std::count_if(ends.begin(), ends.end(), [](double x) { return x < 12; }));
  CHECK_THROWS_AS(by_sizes({{0, 1e-9}}, 0, 1), InputError);
}

TEST_CASE("boxes, plates and tubes have the places of their divisions", "[primitives]") {
  const Division fine = by_sizes({{-1, 0.4}, {0, 0.1}, {1, 0.4}}, -2, 2);
  Divisions<3> elements{1, 3, 2};
  elements[0] = fine;
  elements[2].bias = 4;
  const Mesh mesh = plate("p", {4, 1}, 0.5, elements);
  CHECK(check(mesh).faults.empty());
  const std::vector<double> x = places(fine, -2, 2);
  for (std::size_t i = 0; i < x.size(); ++i) CHECK(mesh.coordinates[i][0] == x[i]);
  CHECK(mesh.coordinates[4 * x.size()][2] == Approx(0.1));
  CHECK(mesh.side_sets.at("p_zmax").size() == static_cast<std::size_t>(3 * fine.cells));
  CHECK_THROWS_WITH(box("b", {1, 1, 1},
                        [] {
                          Divisions<3> wrong{1, 1, 1};
                          wrong[1].bias = -1;
                          return wrong;
                        }()),
                    Catch::Contains("out of range: bias of elements is -1"));
}

TEST_CASE("a cylinder of given sizes has circles from the first place on", "[primitives]") {
  Divisions<2> elements{1, 2};
  elements[0] = by_sizes({{10, 0.5}, {14, 0.5}, {250, 15}}, 0, 250);
  const Mesh mesh = cylinder("c", 250, 12, elements);
  CHECK(check(mesh).faults.empty());
  CHECK(elements_around(elements[0]) == 96);
  const std::vector<double> radii = places(elements[0], 0, 250);
  for (std::size_t i = 20; i < radii.size(); ++i)
    CHECK(std::count_if(mesh.coordinates.begin(), mesh.coordinates.end(), [&](const Vec3& x) {
            return x[2] == 0 && std::abs(x.head<2>().norm() - radii[i]) < 1e-12 * radii[i];
          }) == 96);
  Mesh even = cylinder("c", 10, 12, {20, 2});  // within the first circle the section is that of an even cylinder
  const auto core = std::count_if(mesh.coordinates.begin(), mesh.coordinates.end(),
                                  [](const Vec3& x) { return x[2] == 0 && x.head<2>().norm() < 10.1; });
  REQUIRE(3 * core == static_cast<std::ptrdiff_t>(even.coordinates.size()));
  for (std::ptrdiff_t n = 0; n < core; ++n)
    CHECK((mesh.coordinates[static_cast<std::size_t>(n)] - even.coordinates[static_cast<std::size_t>(n)]).norm() <
          1e-12);
}
