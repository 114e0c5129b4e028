// SPDX-License-Identifier: Apache-2.0
// What rows are given besides what detection finds: the roughest friction of a node's blocks, slabs of eq. (29).
#include <algorithm>
#include <catch2/catch.hpp>

#include "contact/contact.hpp"
#include "tests/support/mass_points.hpp"

using namespace brunt;
using contact::ContactSettings;
using support::MassPoints;

namespace {

/// Two cubes of one body, blocks 0 and 1, side by side along x, come down on a coarser plate, block 2.
MassPoints cubes_on_plate(const comm::Communicator& ranks) {
  mesh::Mesh mesh;
  support::append_box(mesh, {0, 0, 0}, {2, 1, 1}, {2, 1, 1});
  mesh::Block second;
  second.name = "second";
  std::vector<LocalIndex>& both = mesh.blocks[0].nodes;
  second.nodes.assign(both.begin() + 8, both.end());
  both.resize(8);
  mesh.blocks.push_back(second);
  support::append_box(mesh, {-1, -1, -1.001}, {4, 4, 1}, {2, 2, 1});
  MassPoints points(
      ranks, mesh, [&](GlobalIndex gid) { return static_cast<Rank>(gid % ranks.size()); },
      [](const Vec3&) { return 1.0; }, [](const Vec3& x) { return x.z() > -0.0005 ? Vec3(0.1, 0, -1) : Vec3::Zero(); });
  points.mesh.blocks.resize(3);
  return points;
}

/// frictions: of the cubes on the plate.
ContactSettings apart_but_for_the_plate(const std::array<double, 2>& frictions) {
  ContactSettings settings;
  settings.specification.pairs = contact::PairTable(3, {});
  for (const std::int32_t cube : {0, 1}) {
    const double friction = frictions[static_cast<std::size_t>(cube)];
    settings.specification.pairs.set(cube, 2,
                                     {.rule = contact::PairRule::automatic, .friction = {friction, friction, 0}});
  }
  return settings;
}

/// Where the row's slave was at the start; gids are places in the mesh: 3 x 2 x 2 nodes, x fastest.
int column_of(const contact::Row& row) {
  return static_cast<int>(row.key.slave % 3);
}

/// Rows of nodes with faces of the last step.
std::vector<contact::Row> node_rows(const contact::Contact& contact) {
  std::vector<contact::Row> rows(contact.step.rows.begin(), contact.step.rows.end());
  std::erase_if(rows, [](const contact::Row& row) { return row.is_edge() || row.is_wall(); });
  return rows;
}

}  // namespace

TEST_CASE("rows: a node of two blocks has the rougher one's friction") {
  MassPoints points = cubes_on_plate(comm::Communicator::world());
  const ContactSettings settings = apart_but_for_the_plate({0.1, 0.4});
  contact::Contact contact = points.make_contact(settings);
  points.step(contact, 0.01);
  GlobalIndex seen = 0;
  for (const contact::Row& row : node_rows(contact)) {
    CHECK(row.friction == (column_of(row) == 0 ? 0.1 : 0.4));
    ++seen;
  }
  CHECK(points.ranks.sum(seen) == 6);
}

TEST_CASE("rows: slabs are Z1 Z2 / (Z1 + Z2) times the area that a node has against the face") {
  MassPoints points = cubes_on_plate(comm::Communicator::world());
  ContactSettings settings = apart_but_for_the_plate({0, 0});
  settings.specification.enforcement.method = contact::Method::printed;
  settings.blocks.impedance = {3, 5, 6};
  contact::Contact contact = points.make_contact(settings);
  points.step(contact, 0.01);
  GlobalIndex seen = 0;
  for (const contact::Row& row : node_rows(contact)) {
    const double area = column_of(row) == 1 ? 0.5 : 0.25;  // a quarter of a face of each cube; sides count nothing
    const double one = column_of(row) == 2 ? 5 : 3;        // of the first of its blocks
    CHECK(row.slab == Approx(one * 6 / (one + 6) * area).epsilon(1e-12));
    ++seen;
  }
  CHECK(points.ranks.sum(seen) == 6);
}
