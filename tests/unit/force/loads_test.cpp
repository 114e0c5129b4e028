// SPDX-License-Identifier: Apache-2.0
// Mass and loads on single faces and elements, against values by hand.
#include "force/loads.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <numeric>

#include "core/error.hpp"
#include "force/dead_loads.hpp"
#include "force/folded.hpp"
#include "force/pressure_tangent.hpp"
#include "support/element_block.hpp"

using namespace brunt;
using element::ElementKind;
using test::ElementBlockBench;

namespace {

ElementBlockBench unit_cube() {
  ElementBlockBench cube(ElementKind::hex8, material::Elastic{2, 100, 0.3}, {1, 1, 1});
  cube.model.blocks[0].input = {7, 7, 7, 7, 7, 7, 7, 7};
  for (std::size_t i = 0; i < 8; ++i) cube.model.mesh.coordinates.push_back(cube.reference(i));
  cube.scratch.load.assign(8, Quad{});
  return cube;
}

Vec3 of(const Quad& q) {
  return {q[0], q[1], q[2]};
}

/// The top of the cube; of `box` the nodes run x fastest, so that its corners are 4, 5, 7, 6.
const mesh::ExteriorFace top{.key = 5, .nodes = {4, 5, 7, 6}};

}  // namespace

TEST_CASE("lumped mass: every corner takes an equal share, the sum is density times volume") {
  for (const ElementKind kind : {ElementKind::hex8, ElementKind::tet4}) {
    ElementBlockBench bench(kind, material::Elastic{3, 100, 0.3}, {2, 1, 1});
    force::lump_mass(bench.model, bench.state, bench.scratch);
    double sum = 0;
    for (const Quad& mass : bench.scratch.force) sum += mass[0];
    CHECK(sum == Approx(3 * 2).epsilon(1e-14));
    if (kind == ElementKind::tet4) continue;
    for (std::size_t i = 0; i < bench.scratch.force.size(); ++i)  // two elements meet at x = 1
      CHECK(bench.scratch.force[i][0] == Approx(bench.reference(i).x() == 1 ? 0.75 : 0.375).epsilon(1e-14));
  }
}

TEST_CASE("lumped mass: an element without volume in the reference is refused") {
  ElementBlockBench bench = unit_cube();
  for (std::size_t i = 4; i < 8; ++i) bench.model.reference[i][2] = 0;
  CHECK_THROWS_AS(force::lump_mass(bench.model, bench.state, bench.scratch), GuardError);
}

TEST_CASE("gravity: mass times acceleration times its curve, in place of what was there") {
  ElementBlockBench bench = unit_cube();
  bench.model.loads.gravity = {1, -2, 3};
  bench.model.loads.gravity_curve = {{0, 0}, {2, 1}};
  bench.state.time = 0.5;
  for (std::size_t i = 0; i < 8; ++i) bench.state.nodes[i].mass = static_cast<double>(i + 1);
  bench.scratch.load.assign(8, Quad{9, 9, 9, 0});
  force::body_loads(bench.model, bench.state, bench.scratch);
  for (std::size_t i = 0; i < 8; ++i) {
    const double mass = 0.25 * static_cast<double>(i + 1);
    CHECK((of(bench.scratch.load[i]) - mass * Vec3(1, -2, 3)).norm() <= 1e-15 * mass);
  }
}

TEST_CASE("pressure: a quarter of value times area on each corner, inwards, on the face as it is now") {
  ElementBlockBench bench = unit_cube();
  bench.model.loads.pressure = {{.faces = {top}, .value = 8, .curve = {{0, 1}, {1, 0.5}}}};
  bench.state.time = 1;
  std::vector<Quad> slots(4);
  force::pressure_forces(bench.model, bench.state, slots);
  for (const Quad& slot : slots) CHECK((of(slot) - Vec3(0, 0, -1)).norm() <= 1e-15);
  bench.place([](const Vec3& X) { return Vec3(X[2], 2 * X[0], 3 * X[1]); }, 1);  // its normal is now x, its area 6
  force::pressure_forces(bench.model, bench.state, slots);
  for (const Quad& slot : slots) CHECK((of(slot) - Vec3(-6, 0, 0)).norm() <= 1e-14);
}

TEST_CASE("pressure: triangles take thirds; a face whose element is gone takes nothing") {
  ElementBlockBench bench = unit_cube();
  const mesh::ExteriorFace triangle{.key = 9, .nodes = {4, 5, 7, no_index}};
  bench.model.loads.pressure = {{.faces = {triangle, top}, .value = 6, .curve = {}}};
  bench.state.living.pressed = {{1, 0}};
  std::vector<Quad> slots(7, Quad{5, 5, 5, 0});
  force::pressure_forces(bench.model, bench.state, slots);
  for (std::size_t k = 0; k < 7; ++k) CHECK((of(slots[k]) - Vec3(0, 0, k < 3 ? -1 : 0)).norm() <= 1e-15);
}

TEST_CASE("pressure: corners have keys of their own, load by load") {
  ElementBlockBench bench = unit_cube();
  bench.model.loads.pressure = {{.faces = {top}, .value = 1, .curve = {}}, {.faces = {top}, .value = 2, .curve = {}}};
  const std::vector<force::PressureCorner> corners = force::pressure_corners(bench.model);
  REQUIRE(corners.size() == 8);
  for (std::size_t k = 1; k < 8; ++k) CHECK(corners[k].key > corners[k - 1].key);
  for (std::size_t k = 0; k < 8; ++k) CHECK(corners[k].node == top.nodes[k % 4]);
}

TEST_CASE("dead loads: weight times value times curve is added, load by load; areas are of the reference") {
  ElementBlockBench bench = unit_cube();
  model::DeadLoad load;
  load.value = {1, 0, 2};
  load.curve = {{0, 0}, {1, 2}};
  load.nodes = {1, 4};
  load.weight = {0.5, 3};
  bench.model.loads.dead = {load, load};
  bench.scratch.load[4] = Quad{1, 1, 1, 0};
  force::add_dead_loads(bench.model, 0.25, bench.scratch);  // the curve says 0.5 there
  CHECK((of(bench.scratch.load[1]) - Vec3(0.5, 0, 1)).norm() <= 1e-15);
  CHECK((of(bench.scratch.load[4]) - Vec3(4, 1, 7)).norm() <= 1e-15);
  CHECK(of(bench.scratch.load[0]).norm() == 0);
  bench.place([](const Vec3& X) { return Vec3(5 * X); }, 1);
  CHECK(force::reference_area(bench.model, top) == Approx(1).epsilon(1e-15));
  CHECK(force::reference_area(bench.model, {.nodes = {4, 5, 7, no_index}}) == Approx(0.5).epsilon(1e-15));
}

TEST_CASE("damping acts from its first time on, up to but without its last") {
  model::Model model;
  model.loads.damping.alpha = 5;
  model.loads.damping.from = 1;
  model.loads.damping.to = 2;
  for (const auto& [time, rate] : {std::pair{0.999, 0.0}, {1.0, 5.0}, {1.999, 5.0}, {2.0, 0.0}})
    CHECK(force::damping_rate(model, time) == rate);
}

TEST_CASE("folded elements: a corner pushed through the opposite face counts, a flat one does not") {
  ElementBlockBench bench = unit_cube();
  const auto corner_at = [&](double height) {
    bench.place([&](const Vec3& X) { return X == Vec3(1, 1, 1) ? Vec3(1, 1, height) : X; }, 1);
    return force::folded_elements(bench.model, bench.state);
  };
  CHECK(corner_at(1).count == 0);
  CHECK(corner_at(0).count == 0);
  const force::FoldedElements folded = corner_at(-0.5);
  CHECK(folded.count == 1);
  CHECK(folded.element == 7);
  CHECK(folded.block == 0);
  CHECK(folded.worst < -0.3);
  CHECK(folded.worst >= -1);
}

TEST_CASE("the tangent of a pressure is the slope of its forces, on warped quadrilaterals and triangles") {
  const std::array<Vec3, 4> corners{Vec3(0, 0, 0), Vec3(1, 0.1, 0.3), Vec3(1.2, 0.9, -0.2), Vec3(-0.1, 1.1, 0.4)};
  for (const std::size_t n : {3UL, 4UL}) {
    const auto force = [&](const std::array<Vec3, 4>& at) {
      const Vec3 first = n == 3 ? at[1] - at[0] : at[2] - at[0], second = n == 3 ? at[2] - at[0] : at[3] - at[1];
      return Vec3(-7.0 / static_cast<double>(n) * 0.5 * first.cross(second));
    };
    const std::array<Mat3, 4> tangent = force::pressure_tangent(7.0, {corners.data(), n});
    for (std::size_t k = 0; k < n; ++k)
      for (int c = 0; c < 3; ++c) {
        std::array<Vec3, 4> ahead = corners, behind = corners;
        ahead[k][c] += 0.5;  // the force is bilinear: differences are exact
        behind[k][c] -= 0.5;
        CHECK((force(ahead) - force(behind) - tangent[k].col(c)).norm() < 1e-14);
      }
  }
}
