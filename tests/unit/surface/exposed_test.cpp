// SPDX-License-Identifier: Apache-2.0
// The outside of a row of three cubes that loses them one by one, counted by hand; on many ranks, against the whole
// mesh: tests/ranks/surface.
#include "surface/exposed.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <vector>

#include "mesh/topology.hpp"
#include "tests/support/small_mesh.hpp"

using namespace brunt;

namespace {

using Flags = std::vector<std::vector<double>>;

/// Elements 0, 1, 2 along x; nodes in lexicographic order, x fastest: 0-3 on the line y = z = 0.
struct Row {
  comm::Communicator self = comm::Communicator::self();
  mesh::LocalMesh mesh;
  surface::InnerFaces inner;

  Row() {
    mesh::Mesh whole;
    support::append_box(whole, {0, 0, 0}, {3, 1, 1}, {3, 1, 1});
    mesh = support::deal_out(whole, 0, [](GlobalIndex) { return 0; });
    std::vector<mesh::ExteriorFace> faces;
    const std::vector<char> all(whole.coordinates.size(), 1);
    for (const mesh::Side& side : mesh::interior_sides(whole, all))
      faces.push_back({.key = side.element * 8 + side.face,
                       .nodes = mesh::face_nodes(mesh::Shape::hex8, whole.blocks[0].element(side.element), side.face)});
    std::ranges::reverse(faces);  // the order given does not matter
    inner = surface::join_faces(self, mesh, std::move(faces));
  }
  [[nodiscard]] std::vector<GlobalIndex> outside(const Flags& alive) const {
    std::vector<GlobalIndex> keys;
    for (const mesh::ExteriorFace& face : surface::exposed_surface(self, mesh, inner, alive).faces)
      keys.push_back(face.key);
    return keys;
  }
};

constexpr GlobalIndex xmax = 1, xmin = 3;  // local faces, core/cells.hpp

}  // namespace

TEST_CASE("exposed surface: inner faces come by key, each with the element on its other side") {
  const Row row;
  REQUIRE(row.inner.faces.size() == 4);
  const std::vector<GlobalIndex> keys{0 * 8 + xmax, 1 * 8 + xmax, 1 * 8 + xmin, 2 * 8 + xmin};
  const std::vector<LocalIndex> beyond{1, 2, 0, 1};
  for (std::size_t f = 0; f < 4; ++f) {
    CHECK(row.inner.faces[f].key == keys[f]);
    const auto others = row.inner.beyond.row(static_cast<LocalIndex>(f));
    REQUIRE(others.size() == 1);
    CHECK(others[0] == beyond[f]);
  }
  CHECK_FALSE(row.inner.any_foreign);
}

TEST_CASE("exposed surface: while all live it is the outside of the mesh; no flags say the same") {
  const Row row;
  std::vector<GlobalIndex> keys;
  for (const mesh::ExteriorFace& face : row.mesh.faces) keys.push_back(face.key);
  CHECK(keys.size() == 14);
  CHECK(row.outside({}) == keys);
  CHECK(row.outside({{1, 1, 1}}) == keys);
}

TEST_CASE("exposed surface: the middle one goes, and its neighbours' faces come out under their own keys") {
  const Row row;
  const std::vector<GlobalIndex> keys = row.outside({{1, 0, 1}});
  CHECK(keys.size() == 12);
  CHECK(std::ranges::is_sorted(keys));
  CHECK(std::ranges::count_if(keys, [](GlobalIndex key) { return key / 8 == 1; }) == 0);
  CHECK(std::ranges::binary_search(keys, 0 * 8 + xmax));
  CHECK(std::ranges::binary_search(keys, 2 * 8 + xmin));
  CHECK(row.outside({{0, 0, 0}}).empty());
}

TEST_CASE("exposed surface: nodes without an element fly on, or are dropped where it takes them along") {
  const Row row;
  const std::vector<LocalIndex> at_end{0, 4, 8, 12};  // x = 0
  const surface::BareNodes kept = surface::bare_nodes(row.self, row.mesh, Flags{{0, 1, 1}});
  CHECK(kept.kept == at_end);
  CHECK(kept.dropped.empty());
  const surface::BareNodes dropped = surface::bare_nodes(row.self, row.mesh, Flags{{-1, 1, 1}});
  CHECK(dropped.kept.empty());
  CHECK(dropped.dropped == at_end);
  CHECK(surface::bare_nodes(row.self, row.mesh, Flags{{1, 0, 1}}).kept.empty());  // its neighbours hold them
}

TEST_CASE("exposed surface: each mass point is named once, by the first face of its removed element there") {
  const Row row;
  const auto points = surface::exposed_surface(row.self, row.mesh, row.inner, Flags{{0, 0, 1}}).points;
  std::vector<LocalIndex> nodes;
  for (const surface::MassPoint& point : points) {
    nodes.push_back(point.node);
    CHECK(point.key / 8 <= 1);
    CHECK(point.block == 0);
  }
  CHECK(nodes == std::vector<LocalIndex>{0, 1, 4, 5, 8, 9, 12, 13});
  CHECK(surface::exposed_surface(row.self, row.mesh, row.inner, Flags{{-1, -1, 1}}).points.empty());
}
