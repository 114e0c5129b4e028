// SPDX-License-Identifier: Apache-2.0
// Two passes on any number of ranks: the same bits, also with friction, folds, a wall and a history that goes home.
#include <catch2/catch.hpp>

#include "contact/contact.hpp"
#include "tests/support/mass_points.hpp"

using namespace brunt;
using contact::ContactSettings;
using contact::Rebuild;
using support::MassPoints;

namespace {

constexpr double dt = 0.01;

Rank by_stripes(GlobalIndex gid, int ranks) {
  return static_cast<Rank>((gid / 3 * 7 + gid % 2) % ranks);
}
Rank bodies_apart(GlobalIndex gid, int ranks) {
  return gid < 16 ? 0 : ranks - 1;
}

/// A plate falls askew onto one of nearly equal mesh, which lies over a wall.
MassPoints plates(const comm::Communicator& ranks, Rank (*deal)(GlobalIndex, int)) {
  mesh::Mesh mesh;
  support::append_box(mesh, {0, 0, 0}, {4, 4, 1}, {4, 4, 1});
  support::append_box(mesh, {0.3, 0.2, 1.02}, {3.1, 3.3, 0.5}, {4, 4, 1});
  MassPoints points(
      ranks, mesh, [&](GlobalIndex gid) { return deal(gid, ranks.size()); },
      [](const Vec3& x) { return 1 + 0.3 * std::sin(3 * x.x() + 5 * x.y() + x.z()); },
      [](const Vec3& x) { return x.z() > 1.01 ? Vec3(0.3, -0.2 + 0.1 * x.x(), -1) : Vec3(0, 0.05 * x.x(), 0); });
  points.mesh.blocks.resize(2);
  points.walls = {{.point = Vec3(0, 0, -0.03), .normal = Vec3::UnitZ(), .friction = {0.1, 0.1, 0}}};
  return points;
}

/// Two bodies that do not meet themselves.
ContactSettings two_passes(double friction, contact::Passes passes = contact::Passes::two) {
  ContactSettings settings;
  settings.specification.pairs = contact::PairTable(2, {});
  settings.specification.pairs.set(0, 1, {contact::PairRule::automatic, passes, {friction, friction, 0}});
  return settings;
}

void press(MassPoints& points, contact::Contact& contact, int steps) {
  for (int step = 0; step < steps; ++step) {
    for (std::size_t n = 0; n < points.v.size(); ++n) points.v[n].z() -= 0.1 * (points.mesh.coordinates[n].z() + 0.2);
    points.step(contact, dt);
  }
}

std::vector<double> run(const comm::Communicator& ranks, Rank (*deal)(GlobalIndex, int), ContactSettings settings,
                        const Rebuild& rebuild = {}) {
  MassPoints points = plates(ranks, deal);
  settings.specification.rebuild = rebuild;
  contact::Contact contact = points.make_contact(std::move(settings));
  press(points, contact, 40);
  CHECK(contact.ledger.statistics.solved_steps > 10);
  std::vector<double> all = points.all_velocities();
  CHECK(points.copies_agree(all));
  return all;
}

}  // namespace

TEST_CASE("two passes have the same bits on any number of ranks and whenever lists are made") {
  const auto passes = GENERATE(contact::Passes::two, contact::Passes::averaged);
  const double friction = GENERATE(0.0, 0.3);
  ContactSettings settings = two_passes(friction, passes), one = two_passes(friction, contact::Passes::one);
  settings.specification.enforcement.warm_start = one.specification.enforcement.warm_start = GENERATE(false, true);
  const std::vector<double> expected = run(comm::Communicator::self(), by_stripes, settings);
  const comm::Communicator world = comm::Communicator::world();
  CHECK((run(world, by_stripes, settings) == expected));
  CHECK((run(world, bodies_apart, settings) == expected));
  CHECK((run(world, by_stripes, settings, {.when = Rebuild::When::every, .steps = 1}) == expected));
  CHECK((run(world, by_stripes, settings, {.when = Rebuild::When::random}) == expected));
  CHECK((run(world, by_stripes, one) != expected));
}

TEST_CASE("two passes: nodes of both sides have rows, momentum to round-off, the work is booked") {
  const auto passes = GENERATE(contact::Passes::automatic, contact::Passes::averaged);
  const comm::Communicator world = comm::Communicator::world();
  MassPoints points = plates(world, by_stripes);
  points.walls.clear();
  contact::Contact contact = points.make_contact(two_passes(0, passes));
  const Vec3 momentum = points.momentum();
  const double start = points.kinetic();
  GlobalIndex first = 0, second = 0;
  for (int step = 0; step < 40; ++step) {
    points.step(contact, dt);
    for (const contact::Row& row : contact.step.rows) {
      first += row.pass == contact::Pass::first ? 1 : 0;
      second += row.pass == contact::Pass::second ? 1 : 0;
    }
  }
  CHECK(world.sum(first) > 0);
  CHECK(world.sum(second) > 0);
  CHECK((points.momentum() - momentum).norm() <= 1e-12 * (1 + momentum.norm()));
  CHECK(contact::collect(contact).contact_work == Approx(start - points.kinetic()).epsilon(1e-10));
  CHECK(start - points.kinetic() > 0.05 * start);
}

TEST_CASE("the history of two passes with friction goes home and the run goes on to the same bits") {
  const auto passes = GENERATE(contact::Passes::two, contact::Passes::averaged);
  const comm::Communicator world = comm::Communicator::world();
  ContactSettings settings = two_passes(0.4, passes);
  settings.specification.enforcement.warm_start = true;
  MassPoints points = plates(world, by_stripes);
  contact::Contact contact = points.make_contact(settings);
  press(points, contact, 25);
  CHECK(world.sum(static_cast<GlobalIndex>(contact.history.anchors.size())) > 0);
  MassPoints again = plates(world, by_stripes);
  again.x = points.x;
  again.v = points.v;
  again.walls = points.walls;
  contact::Contact resumed = again.make_contact(settings);
  contact::restore_history(contact::history_tables(contact), resumed);
  press(points, contact, 10);
  press(again, resumed, 10);
  CHECK((again.all_velocities() == points.all_velocities()));
}

TEST_CASE("coincident nodes: equal meshes that lie node on node have one row each, and the bits of one pass") {
  const comm::Communicator world = comm::Communicator::world();
  const auto passes = GENERATE(contact::Passes::automatic, contact::Passes::averaged);
  std::vector<double> all[2];
  std::size_t most_rows[2]{};
  for (const bool two : {false, true}) {
    mesh::Mesh mesh;
    support::append_box(mesh, {0, 0, 0}, {4, 4, 1}, {4, 4, 1});
    support::append_box(mesh, {0, 0, 1}, {4, 4, 1}, {4, 4, 1});
    MassPoints points(
        world, mesh, [&](GlobalIndex gid) { return by_stripes(gid, world.size()); }, [](const Vec3&) { return 1.0; },
        [](const Vec3& x) { return Vec3(0, 0, x.z() > 1 ? -1 - 0.1 * x.x() : 0.0); });
    points.mesh.blocks.resize(2);
    contact::Contact contact = points.make_contact(two_passes(0, two ? passes : contact::Passes::one));
    for (int step = 0; step < 20; ++step) {
      points.step(contact, dt);
      most_rows[two ? 1 : 0] = std::max(most_rows[two ? 1 : 0], contact.step.rows.size());
    }
    all[two ? 1 : 0] = points.all_velocities();
  }
  CHECK((all[0] == all[1]));
  CHECK(most_rows[0] == most_rows[1]);
}
