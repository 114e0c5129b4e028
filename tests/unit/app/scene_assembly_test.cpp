// SPDX-License-Identifier: Apache-2.0
// Which parts of a scene move as one, in which directions, and which pairs must come apart.
#include "app/whole/scene_assembly.hpp"

#include <fmt/format.h>

#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "app/whole/start_rules.hpp"
#include "core/error.hpp"
#include "mesh/assemble.hpp"
#include "mesh/primitives.hpp"
#include "scene/build/select.hpp"
#include "scene/read/read.hpp"

using namespace brunt;
using BlockNumbers = std::vector<std::size_t>;

namespace {

struct AssemblyScene {
  scene::Input input;
  mesh::CanonicalMesh whole;
  setup::StartRules rules;
  AssemblyScene(mesh::Mesh mesh, const std::string& parts, const std::string& more)
      : input(scene::read_scene(fmt::format("units: none\nmesh: {{file: of_the_test}}\nrun: {{end: 1, step: 1}}\n"
                                            "materials: {{m: {{model: elastic, density: 1, young: 1, poisson: 0}}, "
                                            "r: {{model: rigid, density: 1}}}}\nparts: {{{}}}\n{}",
                                            parts, more),
                                "test.yaml")),
        whole(mesh::canonical_order(std::move(mesh))) {
    scene::select(input, whole);
    rules = app::start_rules(input, whole.mesh);
  }
  [[nodiscard]] BlockNumbers members() const { return app::members_of_blocks(input, whole.mesh, rules); }
  [[nodiscard]] std::vector<depth::Member> freedoms() const {
    return app::freedoms_of_members(input, whole.mesh, members());
  }
};

/// Unit cubes along x, one at each place, named a, b, c, ...
mesh::Mesh cubes_at(const std::vector<double>& places) {
  mesh::Mesh mesh;
  for (std::size_t i = 0; i < places.size(); ++i) {
    mesh::Mesh cube = mesh::box(std::string(1, static_cast<char>('a' + i)), {1, 1, 1}, {1, 1, 1});
    mesh::place(cube, 1, Vec3::UnitX(), 0, Vec3(places[i], 0, 0));
    mesh::append(mesh, std::move(cube));
  }
  return mesh;
}

/// The admitted translations are exactly those along `free`, orthonormal ones.
void check_free(const depth::Member& member, const std::vector<Vec3>& free) {
  Mat3 wanted = Mat3::Zero();
  for (const Vec3& direction : free) wanted += direction * direction.transpose();
  CHECK((member.basis * member.basis.transpose() - wanted).norm() < 1e-12);
  CHECK_FALSE(member.turns);
}

}  // namespace

TEST_CASE("scene assembly: parts that share nodes, are tied or are one rigid body are one member") {
  mesh::Mesh mesh = cubes_at({0, 10, 20, 1, 30});
  for (LocalIndex& node : mesh.blocks[4].nodes)  // e has a node of b
    if (node == mesh.blocks[4].nodes[7]) node = mesh.blocks[1].nodes[1];
  const AssemblyScene scene(
      std::move(mesh),
      "a: {material: m}, b: {material: r, rigid: {joins: c}}, c: {material: r}, d: {material: m}, "
      "e: {material: m}",
      "contact: [{between: all}, {between: [d, a], tied: true}]\n");
  CHECK(scene.members() == BlockNumbers{0, 1, 1, 0, 1});
  const AssemblyScene apart(cubes_at({0, 10, 20}), "a: {material: m}, b: {material: r}, c: {material: r}", "");
  CHECK(apart.members() == BlockNumbers{0, 1, 2});
}

TEST_CASE("scene assembly: planes of symmetry at any angle leave translations along both, in any order") {
  const double angle = GENERATE(20.0, 60.0, 90.0, 135.0);
  const bool first = GENERATE(true, false);
  const double a = angle * std::numbers::pi / 180;
  const std::string y = "{point: [0, 0, 0], normal: [0, -1, 0]}",
                    oblique = fmt::format("{{point: [0, 0, 0], normal: [{}, {}, 0]}}", -std::sin(a), std::cos(a));
  CAPTURE(angle, first);
  const auto freedom = [](const std::string& more) {
    return AssemblyScene(cubes_at({0}), "a: {material: m}", more).freedoms().at(0);
  };
  check_free(freedom("symmetry: [" + (first ? y + ", " + oblique : oblique + ", " + y) + "]\n"), {Vec3::UnitZ()});
  check_free(freedom("symmetry: [" + oblique + "]\nfixed: [{part: a, dofs: [x]}]\n"),
             angle == 90 ? std::vector<Vec3>{Vec3::UnitY(), Vec3::UnitZ()} : std::vector<Vec3>{Vec3::UnitZ()});
  check_free(freedom("symmetry: [" + oblique + ", " + oblique + "]\n"),
             {Vec3::UnitZ(), Vec3(std::cos(a), std::sin(a), 0)});
  check_free(freedom("symmetry: [" + oblique + ", " + y + ", {point: [0, 0, 0], normal: [1, 1, 1]}]\n"), {});
}

TEST_CASE("scene assembly: supports hold the whole member, and rigid bodies as their properties are given") {
  const std::vector<depth::Member> members =
      AssemblyScene(cubes_at({0, 10, 20, 30, 40}),
                    "a: {material: r, rigid: {mass: 7}}, b: {material: r, rigid: {centre: [10, 0, 0]}}, "
                    "c: {material: r, rigid: {inertia: [1, 1, 1, 0, 0, 0]}}, d: {material: r, rigid: {joins: a}}, "
                    "e: {material: m}",
                    "fixed: [{part: a, dofs: [rx]}]\nprescribed: [{part: c, dof: y, velocity: 1}]\n")
          .freedoms();
  REQUIRE(members.size() == 4);
  CHECK(members[0].mass == 7);
  check_free(members[0], {Vec3::UnitX(), Vec3::UnitY(), Vec3::UnitZ()});
  check_free(members[1], {});
  CHECK_FALSE(members[1].moves());
  check_free(members[2], {Vec3::UnitX(), Vec3::UnitZ()});
  CHECK(members[3].turns);
  CHECK(members[3].basis.isIdentity(0));
}

TEST_CASE("scene assembly: only what may have to move, or what it may meet, has a body") {
  const AssemblyScene scene(cubes_at({0, 0.9, 1.8, 10, 1.7}),
                            "a: {material: m}, b: {material: m}, c: {material: m}, d: {material: m}, e: {material: m}",
                            "contact: [{between: [a, b], initial_overlap: place}, {between: [b, c]},\n"
                            "  {between: [c, d]}, {between: [b, e], initial_overlap: offset}]\n");
  const app::SceneAssembly parts = app::scene_assembly(scene.input, scene.whole.mesh, scene.rules);
  CHECK(parts.faults.empty());
  REQUIRE(parts.assembly.pairs.size() == 2);
  CHECK(parts.assembly.pairs[0].a == 0);
  CHECK(parts.assembly.pairs[0].b == 1);
  CHECK(parts.assembly.pairs[1].a == 1);
  CHECK(parts.assembly.pairs[1].b == 2);
  for (std::size_t k = 0; k < 5; ++k) {
    CHECK((parts.bodies[k] != nullptr) == (k < 3));
    CHECK(parts.assembly.members[k].moves() == (k < 2));  // c stands in the way, and stays
    CHECK(parts.assembly.members[k].mass == Approx(k < 3 ? 1 : 0));
    CHECK(parts.blocks[k] == BlockNumbers{k});
  }
}

TEST_CASE("scene assembly: surfaces that bound no body are refused by name") {
  const auto refusal = [](const mesh::Mesh& mesh) -> std::string {
    try {
      (void)app::body_of_block(mesh, 0, "part 'a'");
    } catch (const InputError& error) {
      return error.faults().at(0);
    }
    return "";
  };
  CHECK(refusal(mesh::box("a", {1, 1, 1}, {1, 2, 1})).empty());
  CHECK(refusal(mesh::box("a", {1, 1e-5, 1e-5}, {1, 1, 1})).empty());
  CHECK_THAT(refusal(mesh::box("a", {1, 1e-7, 1e-7}, {1, 1, 1})), Catch::StartsWith("part 'a': invalid body: "));
  mesh::Mesh corner = mesh::box("a", {2, 2, 1}, {2, 2, 1});  // two elements that have no more than an edge in common
  corner.blocks[0].nodes.erase(corner.blocks[0].nodes.begin() + 8, corner.blocks[0].nodes.begin() + 24);
  CHECK_THAT(refusal(corner), Catch::StartsWith("part 'a': ") && Catch::Contains("more than two triangles"));
  corner.blocks[0].nodes.clear();
  CHECK(refusal(corner) == "part 'a': missing volume; expected solid elements");
}
