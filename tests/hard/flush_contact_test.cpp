// SPDX-License-Identifier: Apache-2.0
// Bodies that touch exactly: flat on flat with gaps at rounding, corner on corner, bodies that share nodes.
#include <catch2/catch.hpp>
#include <map>

#include "mesh/assemble.hpp"
#include "mesh/primitives.hpp"
#include "support/simulation.hpp"
#include "support/small_mesh.hpp"

using namespace brunt;
using test::Simulation;

namespace {

const std::string materials = "materials: {m: {model: elastic, density: 1, young: 100, poisson: 0.3}}\n";
std::string exact_contact(const std::string& passes = "auto") {
  return "contact: [{between: all, passes: " + passes + ", tolerance: 1.0e-12, max_iterations: 5000}]\n";
}
constexpr double h = 0.25;

/// The upper block (3 x 3 elements) comes down on the lower one (5 x 5 elements of the same size) at 5 % of the wave
/// speed; the interface is z = 0, where gaps of 1e-16 are numbers.
Simulation flat_on_flat(double gap, const Vec3& shift, const std::string& passes) {
  mesh::Mesh mesh = mesh::box("low", {5 * h, 5 * h, 2 * h}, {5, 5, 2});
  mesh::place(mesh, 1, {0, 0, 1}, 0, {0, 0, -2 * h});
  mesh::Mesh top = mesh::box("top", {3 * h, 3 * h, 2 * h}, {3, 3, 2});
  mesh::place(top, 1, {0, 0, 1}, 0, Vec3(h, h, gap) + shift);
  mesh::append(mesh, std::move(top));
  return {std::move(mesh), materials + "parts: {low: {material: m}, top: {material: m}}\n" +
                               "initial: [{part: top, velocity: [0, 0, -0.5]}]\n" + exact_contact(passes)};
}

Vec3 momentum_of(const Simulation& scene, GlobalIndex first, GlobalIndex last) {
  Vec3 sum = Vec3::Zero();
  for (GlobalIndex n = first; n < last; ++n) sum += scene.mass(scene.node(n)) * scene.velocity(scene.node(n));
  return sum;
}

}  // namespace

TEST_CASE("flat on flat: gaps at rounding give one total force, and every node has exactly one face", "[law]") {
  constexpr GlobalIndex low_nodes = 6 * 6 * 3, top_nodes = 4 * 4 * 3;
  struct Place {
    Vec3 shift;
    std::size_t below;  ///< nodes of the lower block under the upper one, none of them coincident with one of it
  };
  for (const auto& [shift, below] :
       {Place{{0, 0, 0}, 0}, Place{{h / 3, 0, 0}, 12}, Place{{h / 3, h / 3, 0}, 9}, Place{{h / 2, -h / 3, 0}, 9}})
    for (const std::string passes : {"one", "two"}) {
      std::vector<double> expected;
      for (const double gap : {0.0, 1e-16 * h, -1e-16 * h, 1e-12 * h, -1e-12 * h}) {
        CAPTURE(shift.transpose(), gap, passes);
        Simulation scene = flat_on_flat(gap, shift, passes);
        std::vector<double> momentum;
        for (int step = 0; step < 12; ++step) {
          scene.step();
          momentum.push_back(momentum_of(scene, 0, low_nodes).z());
          if (step > 0) continue;
          std::map<GlobalIndex, int> rows_of;
          for (const contact::Row& row : scene.contact->step.rows)
            if (!row.is_edge()) ++rows_of[row.key.slave];               // rims hang over faces, open
          CHECK(rows_of.size() == 16 + (passes == "one" ? 0 : below));  // its foot: the upper block is the lighter
          for (const auto& [gid, count] : rows_of) CHECK(count == 1);
        }
        if (expected.empty()) expected = momentum;
        for (std::size_t i = 0; i < momentum.size(); ++i) CHECK(momentum[i] == Approx(expected[i]).epsilon(1e-9));
        CHECK(momentum_of(scene, low_nodes, low_nodes + top_nodes).z() + momentum.back() ==
              Approx(-0.5 * 27 * h * h * h * 2 / 3).epsilon(1e-9));
      }
      CHECK(expected.back() < -0.01 * h * h * h);
    }
}

namespace {

/// A cube that stands on a vertex: its diagonal along z, the vertex at the origin, below (up = -1) or above it.
mesh::Mesh on_its_vertex(const std::string& part, int n, double up, double turn) {
  mesh::Mesh cube = mesh::box(part, {1, 1, 1}, {n, n, n});
  mesh::place(cube, 1, Vec3(1, -1, 0), 180 / std::numbers::pi * std::acos(1 / std::sqrt(3.0)), {0, 0, 0});
  if (cube.coordinates.back().z() < 1.5) throw std::logic_error("the diagonal is not upright");
  if (up < 0) mesh::place(cube, 1, {1, 0, 0}, 180, {0, 0, 0});
  mesh::place(cube, 1, {0, 0, 1}, turn, {0, 0, 0});
  return cube;
}

struct Blow {
  double exchanged = 0;  ///< momentum of the lower cube [momentum]
  double largest = 0;    ///< force of a step [force]
};

Blow corner_on_corner(const Vec3& offset, double turn) {
  constexpr int n = 2;
  mesh::Mesh mesh = on_its_vertex("low", n, -1, turn), top = on_its_vertex("top", n, 1, 0);
  mesh::place(top, 1, {0, 0, 1}, 0, offset + Vec3(0, 0, 1e-3));
  mesh::append(mesh, std::move(top));
  Simulation scene(std::move(mesh), materials + "parts: {low: {material: m}, top: {material: m}}\n" +
                                        "initial: [{part: top, velocity: [0, 0, -0.5]}]\n" + exact_contact());
  Blow blow;
  Vec3 before = Vec3::Zero();
  for (int step = 0; step < 150; ++step) {
    scene.step();
    const Vec3 now = momentum_of(scene, 0, 27);
    if (scene.state.dt > 0) blow.largest = std::max(blow.largest, (now - before).norm() / scene.state.dt);
    before = now;
  }
  blow.exchanged = -before.z();
  return blow;
}

}  // namespace

TEST_CASE("corner on corner: the same blow for offsets of 0, 1e-12, 1e-9, 1e-6 of the side, none far beyond a flat one",
          "[law]") {
  // a flat blow: two cubes face to face exchange all momentum, 0.5, at the force rho c v A / 2
  const double flat_force = 0.5 * std::sqrt(100 * 0.7 / (1.3 * 0.4)) * 0.5;
  for (const double turn : {0.0, 25.0}) {
    const Blow centred = corner_on_corner({0, 0, 0}, turn);
    CHECK(centred.exchanged > 0.01);
    for (const double offset : {1e-12, 1e-9, 1e-6})
      for (const Vec3& aside : {Vec3(1, 0, 0), Vec3(-0.6, 0.8, 0)}) {
        CAPTURE(turn, offset, aside.transpose(), centred.exchanged, centred.largest, flat_force);
        const Blow blow = corner_on_corner(offset * aside, turn);
        CHECK(blow.exchanged == Approx(centred.exchanged).epsilon(0.01));
        CHECK(blow.largest <= 10 * flat_force);
      }
  }
}

TEST_CASE("bodies that share one node, and a T of plates that share one line: no pair with themselves, no crash",
          "[law]") {
  mesh::Mesh corners;
  support::append_box(corners, {0, 0, 0}, {1, 1, 1}, {2, 2, 2});
  support::append_box(corners, {1, 1, 1}, {1, 1, 1}, {2, 2, 2});
  mesh::Mesh tee;  // the web stands with its lower edge on the middle line of the flange's top, one element thick
  support::append_box(tee, {0, 0, 0}, {4, 2, 1}, {4, 2, 1});
  support::append_box(tee, {1, 0, 1}, {1, 2, 3}, {1, 2, 3});
  mesh::Mesh on_edge;  // two cubes along one edge: four faces meet in it
  support::append_box(on_edge, {0, 0, 0}, {1, 1, 1}, {2, 2, 2});
  support::append_box(on_edge, {1, 0, 1}, {1, 1, 1}, {2, 2, 2});
  for (mesh::Mesh* mesh : {&corners, &tee, &on_edge}) {
    std::map<std::array<double, 3>, LocalIndex> place;  // nodes at one place become one
    std::vector<Vec3> kept;
    for (mesh::Block& block : mesh->blocks)
      for (LocalIndex& node : block.nodes) {
        const Vec3 x = mesh->coordinates[static_cast<std::size_t>(node)];
        const auto [found, is_new] = place.insert({{x[0], x[1], x[2]}, static_cast<LocalIndex>(kept.size())});
        if (is_new) kept.push_back(x);
        node = found->second;
      }
    mesh->coordinates = kept;
    for (std::size_t n = 0; n < kept.size(); ++n) mesh->node_id.push_back(static_cast<GlobalIndex>(n + 1));
    GlobalIndex elements = 0;
    for (std::size_t b = 0; b < mesh->blocks.size(); ++b) {
      mesh->blocks[b].id = static_cast<GlobalIndex>(b + 1);
      for (LocalIndex e = 0; e < mesh->blocks[b].count(); ++e) mesh->blocks[b].element_id.push_back(++elements);
    }
    Simulation scene(*mesh, materials + "parts: {box0: {material: m}, box1: {material: m}}\n" +
                                "initial: [{part: box1, velocity: [0, 0, -0.02]}]\n" + exact_contact());
    double start = 0;
    for (int step = 0; step < 200; ++step) {
      scene.step();
      if (step == 0) start = scene.ledger().total();
      if (step == 0) CHECK(scene.contact->step.rows.empty());
      for (const contact::Row& row : scene.contact->step.rows)
        for (LocalIndex i = 1; i < row.node_count; ++i) CHECK(row.nodes[0] != row.nodes[static_cast<std::size_t>(i)]);
    }
    CHECK(start > 0);
    CHECK(scene.ledger().total() == Approx(start).epsilon(1e-9));
    CHECK(scene.ledger().kinetic < start);
  }
}
