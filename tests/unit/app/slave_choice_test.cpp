// SPDX-License-Identifier: Apache-2.0
// The slave foretold: the finer of two bodies, or the one that the scene names.
#include "app/slave_choice.hpp"

#include <catch2/catch.hpp>

#include "brunt/mesh/assemble.hpp"
#include "brunt/mesh/primitives.hpp"
#include "brunt/scene/read.hpp"
#include "brunt/scene/select.hpp"

using namespace brunt;

namespace {

/// Which of block 0 (coarse) and block 1 (fine) may be slave of the other.
std::array<bool, 2> slaves(const std::string& contact) {
  mesh::Mesh mesh = mesh::box("coarse", {1, 1, 1}, {1, 1, 1});
  mesh::Mesh fine = mesh::box("fine", {1, 1, 1}, {3, 3, 3});
  mesh::place(fine, 1, {0, 0, 1}, 0, {0, 0, 1.1});
  mesh::append(mesh, std::move(fine));
  const scene::Input input = scene::read_scene(
      "units: none\nmesh: {file: of_the_test}\nrun: {end: 1}\n"
      "materials: {m: {model: elastic, density: 1, young: 1, poisson: 0}}\n"
      "parts: {coarse: {material: m}, fine: {material: m}}\n" +
          contact,
      "scene of the test");
  mesh::CanonicalMesh whole = mesh::canonical_order(std::move(mesh));
  scene::select(input, whole);
  const app::SlaveChoice choice(input, whole.mesh);
  return {choice.is_slave(0, 0, 1, 1), choice.is_slave(1, 1, 0, 0)};
}

}  // namespace

TEST_CASE("slave choice: the finer body, unless the scene says which") {
  CHECK(slaves("contact: [{between: all}]\n") == std::array{false, true});
  CHECK(slaves("contact: [{between: [coarse, fine], slave: coarse}]\n") == std::array{true, false});
  CHECK(slaves("contact: [{between: [coarse, fine], slave: fine}]\n") == std::array{false, true});
  CHECK(slaves("") == std::array{false, false});
}
