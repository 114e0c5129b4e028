// SPDX-License-Identifier: Apache-2.0
// Contact as a whole knows neither axes nor origin nor numbers: the same bodies turned, mirrored, moved or numbered
// otherwise move as they did, to rounding and what the motion makes of it.
#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "mesh/assemble.hpp"
#include "mesh/canonical.hpp"
#include "mesh/primitives.hpp"
#include "support/other_view.hpp"
#include "support/simulation.hpp"
#include "support/tetrahedra.hpp"

using namespace brunt;
using test::Simulation, test::View;

namespace {

/// Blocks one and two; one stands still.
struct Bodies {
  std::string name;
  mesh::Mesh mesh;
  Vec3 velocity;
  std::string elements[2] = {"hex8", "hex8"};
};

mesh::Mesh with(mesh::Mesh one, mesh::Mesh two) {
  mesh::append(one, std::move(two));
  return one;
}

Bodies blocks_askew() {
  mesh::Mesh two = mesh::box("two", {0.8, 0.8, 0.8}, {3, 3, 3});
  mesh::place(two, 1, {0.1, 0.2, 1}, 5, {0.13, 0.07, 1.02});
  return {"blocks askew", with(mesh::box("one", {1, 1, 1}, {4, 4, 4}), std::move(two)), {0.05, 0.03, -0.5}};
}

Bodies edge_on_edge() {
  const auto bar = [](const std::string& name, double up, double degrees) {
    mesh::Mesh mesh = mesh::box(name, {1.5, 0.5, 0.5}, {5, 2, 2});
    mesh::place(mesh, 1, {1, 0, 0}, 0, {-0.75, -0.25, -0.25});
    mesh::place(mesh, 1, {1, 0, 0}, 45, {0, 0, -up * 0.5 * std::sqrt(0.5)});
    mesh::place(mesh, 1, {0, 0, 1}, degrees, {0.013, -0.021, up > 0 ? 0.0 : 0.005});
    return mesh;
  };
  return {"edge on edge", with(bar("one", 1, 0), bar("two", -1, 77)), {0.02, -0.03, -0.5}};
}

Bodies tube_on_cube() {
  mesh::Mesh two = mesh::tube("two", 0.3, 0.5, 1, {2, 14, 4});
  mesh::place(two, 1, {0, 1, 0}, 90, {0, 0, 0});
  mesh::place(two, 1, {0.3, 0.2, 1}, 11, {0.04, 0.47, 1.6});
  double lowest = 1e300;
  for (const Vec3& x : two.coordinates) lowest = std::min(lowest, x.z());
  mesh::place(two, 1, {0, 0, 1}, 0, {0, 0, 1.005 - lowest});
  return {"tube on cube", with(mesh::box("one", {1, 1, 1}, {3, 3, 3}), std::move(two)), {0.03, 0.05, -0.5}};
}

Bodies tetrahedra() {
  mesh::Mesh two = test::in_tetrahedra(mesh::box("two", {0.8, 0.8, 0.8}, {3, 3, 3}));
  mesh::place(two, 1, {0.4, -0.2, 1}, 20, {0.2, 0.1, 1.1});
  return {"tetrahedra",
          with(test::in_tetrahedra(mesh::box("one", {1, 1, 1}, {3, 3, 3})), std::move(two)),
          {0.05, 0.03, -0.5},
          {"tet4", "tet4"}};
}

/// Alike, so that nothing but their numbers tells slave from master; nodes lie on edges of the other's faces.
Bodies cubes_alike() {
  mesh::Mesh two = mesh::box("two", {1, 1, 1}, {4, 4, 4});
  mesh::place(two, 1, {0, 0, 1}, 0, {0.125, 0, 1.01});
  return {"cubes alike", with(mesh::box("one", {1, 1, 1}, {4, 4, 4}), std::move(two)), {0.02, 0.03, -0.5}};
}

/// A C whose upper arm is pressed on the lower one by a cube: contact of a body with itself.
Bodies pressed_c() {
  mesh::Mesh whole = mesh::box("one", {6, 2, 5}, {6, 2, 5});
  mesh::Block& block = whole.blocks[0];
  std::vector<LocalIndex> kept;
  for (LocalIndex e = 0; e < block.count(); ++e)
    if (const int layer = e / 12; layer == 0 || layer == 4 || e % 6 < 2)
      kept.insert(kept.end(), block.element(e), block.element(e) + 8);
  block.nodes = kept;
  block.element_id.resize(kept.size() / 8);
  for (Vec3& x : whole.coordinates)  // the slot is 0.1 high, and 0.2 at its open end
    x = 0.25 * Vec3(x.x(), x.y(), x.z() <= 1 ? x.z() : x.z() >= 4 ? x.z() - 2.9 + x.x() / 60 : 1 + (x.z() - 1) / 30);
  whole.side_sets.clear();
  whole.node_sets.clear();
  mesh::drop_unused_nodes(whole);
  mesh::Mesh two = mesh::box("two", {0.4, 0.4, 0.4}, {2, 2, 2});
  mesh::place(two, 1, {0, 0, 1}, 9, {1.03, 0.04, 0.57});
  return {"pressed C", with(std::move(whole), std::move(two)), {0, 0.02, -2}};
}

std::string scene_of(const Bodies& bodies, const View& view, const std::string& contact) {
  const Vec3 v = view.turn * bodies.velocity;
  return fmt::format(
      "materials: {{m: {{model: elastic, density: 1, young: 100, poisson: 0.3}}}}\n"
      "parts: {{one: {{material: m, element: {}}}, two: {{material: m, element: {}}}}}\n"
      "initial: [{{part: two, velocity: [{:.17g}, {:.17g}, {:.17g}]}}]\n"
      "contact: [{{between: all, {}, tolerance: 1.0e-12, max_iterations: 5000}}]\n",
      bodies.elements[0], bodies.elements[1], v[0], v[1], v[2], contact);
}

std::vector<View> views() {
  const Mat3 turn = Eigen::AngleAxisd(0.83, Vec3(1, 2, 3).normalized()).toRotationMatrix() *
                    Eigen::AngleAxisd(-1.9, Vec3(2, -1, 1).normalized());
  const Mat3 quarter = Eigen::AngleAxisd(std::numbers::pi / 2, Vec3::UnitX()).toRotationMatrix();
  const Mat3 mirror = Vec3(-1, 1, 1).asDiagonal();
  return {{.name = "turned", .turn = turn},
          {.name = "a quarter turn", .turn = quarter},
          {.name = "moved", .move = {7.123, -3.21, 11.7}},
          {.name = "numbered anew", .numbering = 1},
          {.name = "elements turned", .numbering = 2, .turns_elements = true},
          {.name = "blocks swapped", .swaps_blocks = true},
          {.name = "mirrored", .turn = mirror},
          {.name = "mirrored, turned, numbered", .turn = turn * mirror, .numbering = 3}};
}

/// Largest distance between a node and where it is in the other view, of an edge, by step of contact.
std::vector<double> deviations(const Bodies& bodies, const View& view, const std::string& contact, int contact_steps) {
  const test::Seen seen = test::see(bodies.mesh, view);
  Simulation one(bodies.mesh, scene_of(bodies, {}, contact)), other(seen.mesh, scene_of(bodies, view, contact));
  constexpr double edge = 0.25;
  std::vector<double> largest;
  for (int step = 0; step < 3000 && static_cast<int>(largest.size()) < contact_steps; ++step) {
    one.step();
    other.step();
    if (contact::collect(*one.contact).active == 0 && largest.empty()) continue;
    double now = largest.empty() ? 0 : largest.back();
    for (GlobalIndex n = 0; n < one.nodes(); ++n) {
      const Vec3 x = one.position(one.node(n)) + one.model.mesh.origin;
      const Vec3 y = other.position(other.node(seen.node[static_cast<std::size_t>(n)])) + other.model.mesh.origin;
      now = std::max(now, (view.turn.transpose() * (y - view.move) - x).norm() / edge);
    }
    largest.push_back(now);
  }
  return largest;
}

void check_views(const std::vector<std::string>& contacts) {
  const Bodies bodies =
      GENERATE(blocks_askew(), edge_on_edge(), tube_on_cube(), tetrahedra(), cubes_alike(), pressed_c());
  for (const std::string& contact : contacts)
    for (const View& view : views()) {
      if (bodies.name == "cubes alike" && view.swaps_blocks) continue;
      const bool redundant = bodies.name == "cubes alike" && contact == "passes: two, friction: 0.3";
      const std::vector<double> by_step = deviations(bodies, view, contact, 100);
      CAPTURE(bodies.name, contact, view.name);
      REQUIRE(by_step.size() == 100);
      CHECK(by_step.back() <= (redundant ? 2e-4 : 1e-11));  // 1e-11 is missed by the redundant one, ours: 7e-5
    }
}

}  // namespace

// Seen after 100 steps with contact: 3e-13 of an edge at most, after 400 in all but two scenes 5e-13. Missed:
// - Bodies alike in size of faces and mass: which is the slave goes by their number (contact/surface/surface.cpp,
//   is_slave). With the blocks swapped the cubes are 0.4 of an edge elsewhere after 100 steps in one pass, 1.3e-3 in
//   two.
// - Cubes alike in two passes with friction: rows are rigid and redundant, so that friction admits more than one motion
//   and the iteration does not settle to rounding: 7e-5 of an edge. With `softness: 0.05` they are the same.
// - The C without friction: between 100 and 150 steps rounding decides something, 1.5e-4 of an edge, one way in half of
//   the views and the other way in the rest.
TEST_CASE("the same motion in all other views, in one pass with friction and in two without", "[law]") {
  check_views({"passes: one, friction: 0.3", "passes: two"});
}

TEST_CASE("the same motion in all other views, in one pass and in two, with friction and without", "[.][long][law]") {
  check_views({"passes: one", "passes: two", "passes: one, friction: 0.3", "passes: two, friction: 0.3, softness: 0.05",
               "passes: two, friction: 0.3"});
}

TEST_CASE("elements numbered from other corners give nodes other numbers, so that the views above are others",
          "[law]") {
  const Bodies bodies = blocks_askew();
  const View turned{.name = "elements turned", .numbering = 2, .turns_elements = true};
  const test::Seen seen = test::see(bodies.mesh, turned);
  Simulation one(bodies.mesh, scene_of(bodies, {}, "passes: one")),
      other(seen.mesh, scene_of(bodies, turned, "passes: one"));
  int others = 0;
  for (GlobalIndex n = 0; n < one.nodes(); ++n)
    others += one.node(n) != other.node(seen.node[static_cast<std::size_t>(n)]) ? 1 : 0;
  CHECK(3 * others > one.nodes());
}

TEST_CASE("the same motion in other views: the table", "[.][table]") {
  for (const Bodies& bodies :
       {blocks_askew(), edge_on_edge(), tube_on_cube(), tetrahedra(), cubes_alike(), pressed_c()})
    DYNAMIC_SECTION(bodies.name)
  for (const std::string contact :
       {"passes: one", "passes: two", "passes: one, friction: 0.3", "passes: two, friction: 0.3"})
    for (const View& view : views()) {
      const std::vector<double> by_step = deviations(bodies, view, contact, 400);
      fmt::print("{:14} {:28} {:28}", bodies.name, contact, view.name);
      for (const std::size_t step : {1, 10, 30, 60, 100, 150, 250, 400})
        fmt::print(" {:.1e}", step <= by_step.size() ? by_step[step - 1] : -1.0);
      fmt::print("\n");
      std::fflush(stdout);
    }
  SUCCEED();
}
