// SPDX-License-Identifier: Apache-2.0
// The identity of a mesh: what a run takes from it changes the digits, selections of the scene do not.
#include "app/whole/mesh_identity.hpp"

#include <catch2/catch.hpp>
#include <functional>
#include <set>

#include "app/whole/same_scene.hpp"
#include "core/error.hpp"
#include "mesh/primitives.hpp"

using namespace brunt;
using app::mesh_digits;

namespace {

mesh::CanonicalMesh beam() {
  return mesh::canonical_order(mesh::box("beam", Vec3(1, 1, 2), {1, 1, 2}));
}

}  // namespace

TEST_CASE("mesh identity: each change of the mesh gives other digits") {
  const std::vector<std::function<void(mesh::CanonicalMesh&)>> changes{
      [](mesh::CanonicalMesh& m) { m.mesh.coordinates[3][1] += 1e-15; },
      [](mesh::CanonicalMesh& m) { m.origin[0] = 1; },
      [](mesh::CanonicalMesh& m) { std::swap(m.mesh.blocks[0].nodes[0], m.mesh.blocks[0].nodes[1]); },
      [](mesh::CanonicalMesh& m) { m.mesh.blocks[0].name = "bar"; },
      [](mesh::CanonicalMesh& m) { m.mesh.blocks[0].id = 2; },
      [](mesh::CanonicalMesh& m) { m.mesh.node_id[0] = 77; },
      [](mesh::CanonicalMesh& m) { std::swap(m.input_node[0], m.input_node[1]); },
      [](mesh::CanonicalMesh& m) { std::swap(m.input_element[0][0], m.input_element[0][1]); },
      [](mesh::CanonicalMesh& m) { m.mesh.node_sets["more"] = {1}; },
      [](mesh::CanonicalMesh& m) { m.mesh.side_sets.begin()->second.pop_back(); }};
  const std::string digits = mesh_digits(beam());
  CHECK(digits == mesh_digits(beam()));
  std::set<std::string> all{digits};
  for (const auto& change : changes) {
    mesh::CanonicalMesh other = beam();
    change(other);
    all.insert(mesh_digits(other));
  }
  CHECK(all.size() == changes.size() + 1);
  mesh::CanonicalMesh selected = beam();
  selected.mesh.node_sets["@probe:0"] = {1};
  CHECK(mesh_digits(selected) == digits);
}

TEST_CASE("mesh identity: another mesh under the same scene is refused, a file without one is not") {
  const app::SceneIdentity here{app::with_mesh("scene", beam()), "run.end=1\n"};
  CHECK_NOTHROW(app::refuse_other_scene("a.h5", here, here));
  CHECK_NOTHROW(app::refuse_other_scene("a.h5", {"scene", "run.end=1\n"}, here));
  CHECK(app::expected_of("scene", here.fingerprint) == "scene");
  mesh::CanonicalMesh other = beam();
  other.mesh.coordinates[0][0] += 1;
  for (const std::string values : {"run.end=1\n", ""})
    CHECK_THROWS_WITH(
        app::refuse_other_scene("a.h5", {app::with_mesh("scene", other), values}, here),
        Catch::StartsWith("a.h5: invalid for this mesh") && Catch::Contains("expected unchanged mesh files"));
  CHECK_THROWS_WITH(app::refuse_other_scene("a.h5", {app::with_mesh("other", other), "run.end=2\n"}, here),
                    Catch::Contains("run.end is 2"));
}
