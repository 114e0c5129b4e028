// SPDX-License-Identifier: Apache-2.0
// initial_overlap: place - warped faces on their outer side, parts that share nodes, surfaces that are not closed.
#include "app/whole/place_parts.hpp"

#include <catch2/catch.hpp>
#include <set>

#include "app/whole/scene_assembly.hpp"
#include "app/whole/start_rules.hpp"
#include "app/whole/treat_overlaps.hpp"
#include "mesh/assemble.hpp"
#include "mesh/primitives.hpp"
#include "scene/build/select.hpp"
#include "scene/read/read.hpp"

using namespace brunt;

namespace {

struct Case {
  scene::Input input;
  mesh::CanonicalMesh whole;
  explicit Case(mesh::Mesh mesh, const std::string& more = "")
      : input(scene::read_scene("units: none\nmesh: {file: of_the_test}\nrun: {end: 1}\n"
                                "materials: {m: {model: elastic, density: 1, young: 1, poisson: 0}}\n"
                                "parts: {a: {material: m}, b: {material: m}}\n" +
                                    more + "contact: [{between: all, initial_overlap: place}]\n",
                                "scene of the test")),
        whole(mesh::canonical_order(std::move(mesh))) {
    scene::select(input, whole);
  }
  [[nodiscard]] app::SceneAssembly assembly() const {
    return app::scene_assembly(input, whole.mesh, app::start_rules(input, whole.mesh));
  }
};

mesh::Mesh boxes(const Vec3& at_b) {
  mesh::Mesh mesh = mesh::box("a", {1, 1, 1}, {1, 1, 1});
  mesh::Mesh other = mesh::box("b", {1, 1, 1}, {1, 1, 1});
  mesh::place(other, 1, Vec3(0, 0, 1), 0, at_b);
  mesh::append(mesh, std::move(other));
  return mesh;
}

}  // namespace

TEST_CASE("place: two cubes part by half of their overlap each") {
  Case scene(boxes({0.9, 0, 0}));
  const app::TreatedOverlaps treated = app::treat_overlaps(scene.input, scene.whole);
  CHECK(treated.report.faults.empty());
  REQUIRE(treated.report.notes.size() == 3);
  CHECK_THAT(treated.report.notes[0], Catch::Contains("2 parts placed, moved by 0.05 at most"));
  CHECK(treated.gaps.overlaps.empty());
  CHECK(treated.accepted.empty());
  double low = 1, high = 0;
  for (const Vec3& x : scene.whole.mesh.coordinates) {
    low = std::min(low, x[0]);
    high = std::max(high, x[0]);
  }
  CHECK(high - low == Approx(2).epsilon(1e-6));
}

TEST_CASE("place: warped faces count on their outer side") {
  mesh::Mesh mesh = boxes({0.95, 0, 0});
  for (Vec3& x : mesh.coordinates)  // one corner of the face of a that looks at b stands out, its opposite one too
    if (x[0] == 1 && x[1] == x[2]) x[0] = 1.06;
  Case scene(std::move(mesh));
  const double least = [&] {  // of b
    const app::SceneAssembly parts = scene.assembly();
    CHECK(parts.bodies[0]->mass.mass == Approx(1 + 0.06 * 2 / 3).epsilon(1e-9));  // two tetrahedra of 0.06/6 beyond ...
    return parts.bodies[1]->mass.mass;
  }();
  CHECK(least == Approx(1));
  const app::TreatedOverlaps treated = app::treat_overlaps(scene.input, scene.whole);
  CHECK(treated.report.faults.empty());
  CHECK(treated.gaps.overlaps.empty());
  CHECK(treated.gaps.smallest >= 0);
}

TEST_CASE("place: supports take motions away") {
  const Case free(boxes({0.9, 0, 0}));
  for (const depth::Member& member : free.assembly().assembly.members) {
    CHECK(member.turns);
    CHECK(member.basis.isIdentity(0));
  }
  const Case held(boxes({0.9, 0, 0}),
                  "fixed: [{part: a, dofs: [y]}]\nsymmetry: [{point: [1.9, 0, 0], normal: [1, 0, 0]}]\n");
  const depth::Assembly assembly = held.assembly().assembly;
  REQUIRE(assembly.members.size() == 2);
  CHECK_FALSE(assembly.members[0].turns);
  CHECK((assembly.members[0].basis.transpose() * Vec3::UnitY()).isZero(0));
  CHECK((assembly.members[0].basis.transpose() * Vec3::UnitX()).norm() == 1);
  CHECK_FALSE(assembly.members[1].turns);
  CHECK((assembly.members[1].basis.transpose() * Vec3::UnitX()).isZero(0));
  CHECK((assembly.members[1].basis.transpose() * Vec3::UnitZ()).norm() == 1);
}
