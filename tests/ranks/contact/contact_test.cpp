// SPDX-License-Identifier: Apache-2.0
// Contact of mass points on any number of ranks against the same on one: the same bits, exact momentum, no energy.
#include "contact/contact.hpp"

#include <catch2/catch.hpp>

#include "tests/support/mass_points.hpp"

using namespace brunt;
using contact::ContactSettings;
using contact::Rebuild;
using support::MassPoints;

namespace {

/// A fine plate falls askew onto a coarse one, nodes of uneven mass; a third body waits far away.
mesh::Mesh two_plates() {
  mesh::Mesh mesh;
  support::append_box(mesh, {0, 0, 0}, {4, 4, 1}, {4, 4, 1});
  support::append_box(mesh, {0.3, 0.2, 1.02}, {3.1, 3.3, 0.5}, {7, 8, 1});
  support::append_box(mesh, {0, 0, 1e4}, {1, 1, 1}, {1, 1, 1});
  return mesh;
}

double mass(const Vec3& x) {
  return 1 + 0.3 * std::sin(3 * x.x() + 5 * x.y() + x.z());
}

Vec3 velocity(const Vec3& x) {
  return x.z() > 1.01 && x.z() < 10 ? Vec3(0.3, -0.2 + 0.1 * x.x(), -1 + 0.2 * x.y()) : Vec3(0, 0.05 * x.x(), 0);
}

Rank by_stripes(GlobalIndex gid, int ranks) {
  return static_cast<Rank>((gid / 3 * 7 + gid % 2) % ranks);
}
Rank bodies_apart(GlobalIndex gid, int ranks) {
  return gid < 16 ? 0 : ranks - 1;
}

constexpr double dt = 0.01;
constexpr int step_count = 40;

std::vector<double> run(const comm::Communicator& ranks, Rank (*deal)(GlobalIndex, int), const Rebuild& rebuild,
                        bool with_wall = false) {
  MassPoints points(
      ranks, two_plates(), [&](GlobalIndex gid) { return deal(gid, ranks.size()); }, mass, velocity);
  if (with_wall) {
    points.walls = {{.point = Vec3(0, 0, -0.03), .normal = Vec3::UnitZ(), .velocity = Vec3(0, 0, 0.1)}};
    for (Vec3& v : points.v) v.z() -= 0.5;
  }
  ContactSettings settings;
  settings.specification.rebuild = rebuild;
  contact::Contact contact = points.make_contact(settings);
  for (int step = 0; step < step_count; ++step) points.step(contact, dt);
  std::vector<double> all = points.all_velocities();
  CHECK(points.copies_agree(all));
  return all;
}

}  // namespace

TEST_CASE("velocities have the same bits on any number of ranks, however elements are dealt out") {
  const bool with_wall = GENERATE(false, true);
  const std::vector<double> expected = run(comm::Communicator::self(), by_stripes, {}, with_wall);
  const comm::Communicator world = comm::Communicator::world();
  CHECK(run(world, by_stripes, {}, with_wall) == expected);
  CHECK(run(world, bodies_apart, {}, with_wall) == expected);
}

TEST_CASE("when lists are rebuilt changes no bit") {
  const comm::Communicator world = comm::Communicator::world();
  const std::vector<double> expected = run(world, by_stripes, {});
  CHECK(run(world, by_stripes, {.when = Rebuild::When::every, .steps = 1}) == expected);
  CHECK(run(world, by_stripes, {.when = Rebuild::When::every, .steps = 7}) == expected);
  CHECK(run(world, by_stripes, {.when = Rebuild::When::random}) == expected);
}

TEST_CASE("momentum to round-off, energy never grows and is booked, nothing passes through") {
  const comm::Communicator world = comm::Communicator::world();
  MassPoints points(
      world, two_plates(), [&](GlobalIndex gid) { return by_stripes(gid, world.size()); }, mass, velocity);
  ContactSettings settings;
  settings.tracked = {{1, 0}, {0, 2}};
  contact::Contact contact = points.make_contact(settings);
  const Vec3 momentum = points.momentum();
  const double start = points.kinetic();
  double kinetic = start, residual = 0;
  for (int step = 0; step < step_count; ++step) {
    points.step(contact, dt);
    const double now = points.kinetic();
    CHECK(now <= kinetic * (1 + 1e-14) + contact.ledger.statistics.last.violation * 1e-6);
    kinetic = now;
    residual = std::max(residual, contact.ledger.statistics.last.residual);
  }
  CHECK((points.momentum() - momentum).norm() <= 1e-13 * (1 + momentum.norm()));
  CHECK(residual <= settings.specification.enforcement.tolerance);
  CHECK(contact.ledger.statistics.solved_steps > 0);
  CHECK(contact.ledger.statistics.searches < step_count / 2);

  const contact::ContactTotals totals = contact::collect(contact);
  CHECK(totals.contact_work == Approx(start - kinetic).epsilon(1e-10));  // no other force acts, so this is all of it
  CHECK(start - kinetic > 0.05 * start);
  CHECK(totals.wall_work == 0);
  CHECK(totals.penetration < 5e-3);
  CHECK(totals.tracked[0].impulse.z() > 0);  // on the upper plate, upward
  CHECK(totals.tracked[1].impulse.norm() == 0);
}

TEST_CASE("one body on a moving wall: the impulse on the body is what its momentum gained") {
  const comm::Communicator world = comm::Communicator::world();
  mesh::Mesh mesh;
  support::append_box(mesh, {0, 0, 0.005}, {2, 2, 1}, {3, 3, 2});
  MassPoints points(
      world, mesh, [&](GlobalIndex gid) { return by_stripes(gid, world.size()); }, mass,
      [](const Vec3&) { return Vec3(0.1, 0, -1); });
  points.walls = {{.normal = Vec3::UnitZ(), .velocity = Vec3(0, 0, 0.25)}};
  ContactSettings settings;
  settings.specification.pairs = contact::PairTable(4, {});
  settings.specification.enforcement.tolerance = 1e-10;
  contact::Contact contact = points.make_contact(settings);
  const Vec3 momentum = points.momentum();
  const double kinetic = points.kinetic();
  for (int step = 0; step < 5; ++step) points.step(contact, dt);
  const contact::ContactTotals totals = contact::collect(contact);
  REQUIRE(totals.wall_impulse.size() == 1);
  CHECK((points.momentum() - momentum - totals.wall_impulse[0]).norm() <= 1e-13 * momentum.norm());
  CHECK(totals.wall_work == Approx(kinetic - points.kinetic()).epsilon(1e-10));
  for (std::size_t n = 0; n < points.x.size(); ++n) {
    if (points.mesh.coordinates[n].z() > 0.01) continue;
    CHECK(points.v[n].z() == Approx(0.25).epsilon(1e-9));  // the foot rides on the wall
    CHECK(points.x[n].z() == Approx(points.walls[0].point.z()).margin(1e-9));
  }
}

TEST_CASE("a bilateral wall holds the nodes that start in it, and a fixed node is never moved") {
  const comm::Communicator world = comm::Communicator::world();
  mesh::Mesh mesh;
  support::append_box(mesh, {0, 0, 0}, {1, 1, 1}, {2, 2, 2});
  MassPoints points(
      world, mesh, [&](GlobalIndex gid) { return by_stripes(gid, world.size()); }, mass,
      [](const Vec3& x) { return x.norm() == 0 ? Vec3(0, 0, 0) : Vec3(0.2, 0, 1); });
  for (std::size_t n = 0; n < points.x.size(); ++n)
    if (points.x[n].norm() == 0) points.constrained.push_back({static_cast<LocalIndex>(n), Mat3::Zero()});
  points.walls = {{.bilateral = true}};
  ContactSettings settings;
  settings.specification.pairs = contact::PairTable(4, {});
  contact::Contact contact = points.make_contact(settings);
  for (int step = 0; step < 5; ++step) points.step(contact, dt);
  for (std::size_t n = 0; n < points.x.size(); ++n) {
    const Vec3 start = points.mesh.coordinates[n];
    if (start.norm() == 0)
      CHECK(points.v[n] == Vec3::Zero());
    else if (start.z() == 0)
      CHECK(points.v[n].z() == Approx(0).margin(1e-12));
    else
      CHECK(points.v[n].z() == 1);
  }
}

TEST_CASE("node on node across ranks: exact") {
  const comm::Communicator world = comm::Communicator::world();
  mesh::Mesh mesh;
  support::append_box(mesh, {0, 0, 0}, {1, 1, 1}, {1, 1, 1});
  support::append_box(mesh, {0, 0, 1}, {1, 1, 1}, {1, 1, 1});
  MassPoints points(
      world, mesh, [&](GlobalIndex gid) { return gid == 0 ? 0 : world.size() - 1; }, [](const Vec3&) { return 1.0; },
      [](const Vec3&) { return Vec3::Zero(); });
  for (std::size_t n = 0; n < points.x.size(); ++n) {
    const bool upper = points.mesh.node_gid[n] >= 8;
    points.inverse_mass[n] = upper ? 1 / 3.0 : 1 / 2.0;
    if (upper) points.v[n] = Vec3(0, 0, -5);
  }
  ContactSettings settings;
  settings.specification.enforcement.tolerance = 1e-12;
  contact::Contact contact = points.make_contact(settings);
  points.step(contact, 1e-3);
  CHECK(contact.ledger.statistics.last.iterations == 1);
  double pressure = 0;
  for (const double p : contact::pressures(contact, 1e-3)) pressure = std::max(pressure, p);
  CHECK(world.max(pressure) == Approx(6 / (1e-3 * 0.25)));  // a corner carries a quarter of its face, nothing of sides
  for (std::size_t n = 0; n < points.x.size(); ++n) {
    if (points.mesh.coordinates[n].z() != 1) continue;
    CHECK(points.v[n].z() == Approx(3 * -5 / 5.0).epsilon(1e-14));
    CHECK(points.v[n].x() == 0);
  }
}

TEST_CASE("a corner of a triangle carries a third of it") {
  const comm::Communicator world = comm::Communicator::world();
  mesh::Mesh mesh;
  support::append_box(mesh, {-1, -1, -1}, {3, 3, 1}, {1, 1, 1});
  const auto first = static_cast<LocalIndex>(mesh.coordinates.size());
  mesh::Block tetrahedron;
  tetrahedron.shape = mesh::Shape::tet4;
  for (const Vec3& corner : {Vec3(0, 0, 0), Vec3(0.6, 0, 0), Vec3(0, 0.5, 0), Vec3(0.2, 0.2, 0.5)}) {
    tetrahedron.nodes.push_back(static_cast<LocalIndex>(mesh.coordinates.size()));
    mesh.coordinates.push_back(corner);
  }
  mesh.blocks.push_back(tetrahedron);
  MassPoints points(
      world, mesh, [&](GlobalIndex gid) { return static_cast<Rank>(gid) % world.size(); },
      [](const Vec3& x) { return x.z() < 0 ? 1e12 : 3.0; },
      [&](const Vec3& x) { return std::abs(x.x()) < 0.9 && x.z() >= 0 ? Vec3(0, 0, -5) : Vec3(0, 0, 0); });
  for (std::size_t n = 0; n < points.x.size(); ++n)
    if (points.mesh.node_gid[n] < first) points.constrained.push_back({static_cast<LocalIndex>(n), Mat3::Zero()});
  ContactSettings settings;
  settings.specification.enforcement.tolerance = 1e-12;
  contact::Contact contact = points.make_contact(settings);
  points.step(contact, 1e-3);
  const std::vector<double> pressure = contact::pressures(contact, 1e-3);
  const double area = 0.5 * 0.6 * 0.5;
  int loaded = 0;
  for (std::size_t n = 0; n < pressure.size(); ++n) {
    if (pressure[n] == 0) continue;
    CHECK(pressure[n] == Approx(3 * 5 / (1e-3 * area / 3)));
    ++loaded;
  }
  CHECK(world.sum(GlobalIndex{loaded}) == 3);
}
