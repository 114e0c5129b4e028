// SPDX-License-Identifier: Apache-2.0
// Ties on any number of ranks: which nodes they hold, the same bits, momentum and angular momentum kept.
#include <Eigen/Geometry>
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

#include "contact/contact.hpp"
#include "core/error.hpp"
#include "tests/support/mass_points.hpp"

using namespace brunt;
using contact::ContactSettings;
using contact::Tied;
using support::MassPoints;

namespace {

constexpr double dt = 0.005;

/// A plate of 7 x 6 nodes a tenth over a coarser one, from x = `from` on, both in some motion.
MassPoints plates(const comm::Communicator& ranks, double from, const std::function<Rank(GlobalIndex)>& deal) {
  mesh::Mesh mesh;
  support::append_box(mesh, {0, 0, 0}, {4, 4, 1}, {4, 4, 1});
  support::append_box(mesh, {from, 0.2, 1.1}, {3, 3.3, 0.5}, {6, 5, 1});
  MassPoints points(
      ranks, mesh, deal, [](const Vec3& x) { return 1 + 0.3 * std::sin(3 * x.x() + 5 * x.y() + x.z()); },
      [](const Vec3& x) { return Vec3(0.1 * std::sin(x.y()), 0.1 * x.z(), 0.2 * std::cos(x.x() - x.y() + x.z())); });
  points.mesh.blocks.resize(2);
  return points;
}

ContactSettings tied(Tied how = Tied::yes) {
  ContactSettings settings;
  settings.specification.pairs = contact::PairTable(2, {});
  settings.specification.pairs.set(0, 1, {.rule = contact::PairRule::automatic, .tied = how});
  settings.specification.enforcement.tolerance = 1e-8;
  settings.specification.enforcement.max_iterations = 1000;
  return settings;
}

Vec3 angular_momentum(const MassPoints& points) {
  Vec3 sum;
  for (int c = 0; c < 3; ++c)
    sum[c] =
        points.sum_of_owned([&](std::size_t n) { return points.x[n].cross(points.v[n])[c] / points.inverse_mass[n]; });
  return sum;
}

Rank striped(GlobalIndex gid, int ranks) {
  return static_cast<Rank>((gid / 3 * 7 + gid % 2) % ranks);
}

}  // namespace

TEST_CASE("ties: each node of the finer side over the other is tied once, those beside it are counted") {
  const comm::Communicator world = comm::Communicator::world();
  const auto deal = [&](GlobalIndex gid) { return striped(gid, world.size()); };
  const auto count = [&](double from) {
    const MassPoints points = plates(world, from, deal);
    return contact::tied_nodes(points.make_contact(tied()));
  };
  const auto [all, none_beside] = count(0.5);
  CHECK(all == std::vector<GlobalIndex>{0, 0, 7 * 6, 0});
  CHECK(none_beside == std::vector<GlobalIndex>(4, 0));
  const auto [held, beside] = count(-0.2);  // a row of six hangs over by 0.2; of their facets .6 are covered
  CHECK(held == std::vector<GlobalIndex>{0, 0, 7 * 6, 0});
  CHECK(beside == std::vector<GlobalIndex>(4, 0));
  const auto [fewer, none] = count(-0.3);  // by 0.3; the functions of these are the next ones'
  CHECK(fewer == std::vector<GlobalIndex>{0, 0, 6 * 6, 0});
  CHECK(none == std::vector<GlobalIndex>(4, 0));
}

TEST_CASE("ties across a gap: momentum, angular momentum and bits do not depend on the ranks") {
  const comm::Communicator world = comm::Communicator::world(), self = comm::Communicator::self();
  const auto run = [](const comm::Communicator& ranks, const contact::Rebuild& rebuild, bool checks) {
    MassPoints points = plates(ranks, -0.2, [&](GlobalIndex gid) { return striped(gid, ranks.size()); });
    ContactSettings settings = tied();
    settings.specification.rebuild = rebuild;
    contact::Contact contact = points.make_contact(settings);
    const Vec3 momentum = points.momentum(), spin = angular_momentum(points);
    const double energy = points.kinetic();
    for (int step = 0; step < 30; ++step) points.step(contact, dt);
    if (checks) {
      CHECK((points.momentum() - momentum).norm() <=
            1e-13 * points.sum_of_owned([&](std::size_t n) { return points.v[n].norm() / points.inverse_mass[n]; }));
      CHECK((angular_momentum(points) - spin).norm() <= 1e-13 * spin.norm());
      const contact::ContactTotals totals = contact::collect(contact);
      CHECK(totals.contact_work + totals.friction_work == Approx(energy - points.kinetic()).epsilon(1e-10));
      CHECK(totals.contact_work + totals.friction_work > 0);
      CHECK(totals.spin.norm() <= 1e-13 * spin.norm());
    }
    std::vector<double> all = points.all_velocities();
    CHECK(points.copies_agree(all));
    return all;
  };
  const std::vector<double> alone = run(self, {}, false);
  CHECK(run(world, {}, true) == alone);
  CHECK(run(world, {contact::Rebuild::When::random}, false) == alone);
}

TEST_CASE("parts torn from each other are told on all ranks") {
  const comm::Communicator world = comm::Communicator::world();
  MassPoints points = plates(world, 0.5, [&](GlobalIndex gid) { return striped(gid, world.size()); });
  contact::Contact contact = points.make_contact(tied());
  points.step(contact, dt);
  for (std::size_t n = 0; n < points.x.size(); ++n)
    if (points.mesh.coordinates[n].z() > 1.05) points.x[n].z() += 3;
  CHECK_THROWS_AS(points.step(contact, dt), GuardError);
}

TEST_CASE("ties alone: no other node of the pair has a row") {
  const comm::Communicator world = comm::Communicator::world();
  for (const Tied how : {Tied::yes, Tied::alone}) {
    MassPoints points = plates(world, 0.5, [&](GlobalIndex gid) { return striped(gid, world.size()); });
    points.x = points.mesh.coordinates;
    for (std::size_t n = 0; n < points.x.size(); ++n) {  // nodes of the upper plate off the reach of ties at x > 2.9
      Vec3& x = points.mesh.coordinates[n];
      if (x.z() > 1.05 && x.x() > 2.9) x.z() += 0.25;
      points.x[n] = x;
      points.v[n] = x.z() > 1.05 ? Vec3(0, 0, -4) : Vec3::Zero();
    }
    contact::Contact contact = points.make_contact(tied(how));
    GlobalIndex ties = 0, others = 0;
    for (int step = 0; step < 20; ++step) {
      points.step(contact, dt);
      ties = others = 0;
      for (const contact::Row& row : contact.step.rows) ++(row.holds ? ties : others);
      ties = world.sum(ties);
      others = world.sum(others);
    }
    CHECK(ties == 5 * 6);
    CHECK((others > 0) == (how == Tied::yes));
  }
}
