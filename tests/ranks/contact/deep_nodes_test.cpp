// SPDX-License-Identifier: Apache-2.0
// Depths by positions: a bar in a thin plate, as deep as its place says, the same on any number of ranks.
#include "contact/deep_nodes.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <catch2/catch.hpp>
#include <numbers>

#include "tests/support/mass_points.hpp"

using namespace brunt;
using support::MassPoints;

namespace {

constexpr double thickness = 0.1;

contact::DeepNodes look_at(const MassPoints& points, const contact::Contact& contact, double above) {
  std::vector<contact::GhostElement> elements;
  for (std::size_t b = 0; b < points.mesh.blocks.size(); ++b) {
    const mesh::LocalBlock& block = points.mesh.blocks[b];
    for (std::size_t e = 0; e < block.gid.size(); ++e) {
      contact::GhostElement element{.gid = block.gid[e], .block = static_cast<std::int32_t>(b)};
      geometry::Box box;
      for (std::size_t c = 0; c < 8; ++c) {
        const auto node = static_cast<std::size_t>(block.nodes[8 * e + c]);
        element.nodes[c] = points.mesh.node_gid[node];
        element.corner[c] = {points.x[node][0], points.x[node][1], points.x[node][2]};
        geometry::extend(box, points.x[node]);
      }
      element.capture = contact::PlainBox(box);
      elements.push_back(element);
    }
  }
  return contact::find_deep_nodes(contact::watched_surface(contact), {reinterpret_cast<const double*>(points.x.data())},
                                  elements, above);
}

/// A plate whose upper face is z = 0, and a bar of one element, upright with its lower end at z = `end`, then turned
/// about x around the middle of its lower end.
struct BarInPlate {
  MassPoints points;
  contact::Contact contact;

  static MassPoints bodies(const comm::Communicator& ranks, double end, double degrees) {
    mesh::Mesh mesh;
    support::append_box(mesh, {0, 0, -thickness}, {4, 4, thickness}, {4, 4, 1});
    const auto first = mesh.coordinates.size();
    support::append_box(mesh, {1.3, 1.6, 0}, {0.5, 0.6, 2}, {1, 1, 1});
    const Vec3 foot(1.55, 1.9, 0);
    const Mat3 turn = Eigen::AngleAxisd(degrees * std::numbers::pi / 180, Vec3::UnitX()).toRotationMatrix();
    for (std::size_t n = first; n < mesh.coordinates.size(); ++n)
      mesh.coordinates[n] = foot + turn * (mesh.coordinates[n] - foot) + Vec3(0, 0, end);
    return {ranks, mesh, [&](GlobalIndex gid) { return static_cast<Rank>(gid * 5 % 7 % ranks.size()); },
            [](const Vec3&) { return 1.0; }, [](const Vec3&) { return Vec3(0, 0, 0); }};
  }
  BarInPlate(const comm::Communicator& ranks, double end, double degrees = 0)
      : points(bodies(ranks, end, degrees)), contact(points.make_contact({})) {}

  [[nodiscard]] contact::DeepNodes look(double above) const { return look_at(points, contact, above); }
};

}  // namespace

TEST_CASE("deep nodes: a bar above a plate, or on it, is not in it") {
  for (const double end : {0.3, 1e-9, 0.0}) {
    const contact::DeepNodes found = BarInPlate(comm::Communicator::world(), end).look(0.01);
    CAPTURE(end);
    CHECK(found.count == 0);
    CHECK(found.worst.share < 1e-8);
  }
}

TEST_CASE("deep nodes: the end of a bar is as deep as its nodes, up to the middle of the plate") {
  for (const double depth : {0.001, 0.02, 0.049}) {
    const contact::DeepNodes found = BarInPlate(comm::Communicator::world(), -depth).look(0.005);
    CAPTURE(depth);
    CHECK(found.worst.depth == Approx(depth));
    CHECK(found.worst.share == Approx(depth / thickness));
    CHECK(found.worst.block == 0);
    CHECK(found.worst.node_block == 1);
  }
}

TEST_CASE("deep nodes: edges that pass squarely through a plate, far from any node, are an element deep") {
  for (const double end : {-0.1001, -0.5, -1.9}) {
    const contact::DeepNodes found = BarInPlate(comm::Communicator::world(), end).look(0.5);
    CAPTURE(end);
    CHECK(found.worst.on_edge);
    CHECK(found.worst.share == Approx(1).epsilon(1e-9));
    CHECK(found.count == 4);
  }
}

TEST_CASE("deep nodes: an edge that lies in a face is as deep as it has sunk, however long it is") {
  // on its side, the lower face horizontal, its edges along y
  for (const double depth : {0.002, 0.03}) {
    const contact::DeepNodes found = BarInPlate(comm::Communicator::world(), 0.3 - depth, 90).look(0.01);
    CAPTURE(depth);
    CHECK(found.worst.depth == Approx(depth).epsilon(1e-6));
    CHECK(found.worst.share < 0.31);
  }
}

TEST_CASE("deep nodes: an edge across a ridge is as deep as the ridge, though the ridge is between two elements") {
  // a roof of two elements with flanks of 45 degrees, its ridge at z = 1; a bar of one element across it. The ridge is
  // deeper in the bar than the bar's two edges in the roof, whose elements are 1 deep
  constexpr double sunk = 0.2;
  const comm::Communicator ranks = comm::Communicator::world();
  mesh::Mesh mesh;
  support::append_box(mesh, {0, 0, -1}, {2, 1, 1}, {2, 1, 1});
  for (Vec3& x : mesh.coordinates)
    if (x[2] == 0 && x[0] == 1) x[2] = 1;
  support::append_box(mesh, {0.1, 0.3, 1 - sunk}, {1.7, 0.4, 1}, {1, 1, 1});
  const MassPoints points(
      ranks, mesh, [&](GlobalIndex gid) { return static_cast<Rank>(gid * 5 % 7 % ranks.size()); },
      [](const Vec3&) { return 1.0; }, [](const Vec3&) { return Vec3(0, 0, 0); });
  const contact::DeepNodes found = look_at(points, points.make_contact({}), 0.01);
  CHECK(found.worst.on_edge);
  CHECK(found.worst.depth == Approx(sunk).epsilon(1e-9));
  const double of_bar = sunk * std::numbers::sqrt2 / 2;
  const auto right = std::ranges::count_if(found.shares, [&](double share) { return std::abs(share - of_bar) < 1e-9; });
  CHECK(ranks.sum(static_cast<GlobalIndex>(right)) == 2);
}
