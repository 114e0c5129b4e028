// SPDX-License-Identifier: Apache-2.0
// Lists that last against a search in every step, where a body that lay still far away is suddenly fast.
#include <catch2/catch.hpp>

#include "contact/contact.hpp"
#include "tests/support/mass_points.hpp"

using namespace brunt;
using contact::Rebuild;
using support::MassPoints;

namespace {

struct Flight {
  std::vector<double> velocity;  ///< of all nodes at the end, by gid
  GlobalIndex searches = 0;
  double deepest = 0;  ///< lowest node of the bullet's foot below the plate's top
};

/// The bullet waits 40 edges over the plate and in step 30 gets a speed of 7 edges a step, downwards and to the side.
Flight fly(const comm::Communicator& ranks, const Rebuild& rebuild) {
  mesh::Mesh mesh;
  support::append_box(mesh, {0, 0, 0}, {12, 12, 0.5}, {12, 12, 1});
  support::append_box(mesh, {3.3, 4.2, 40}, {1.4, 1.4, 1.4}, {3, 3, 3});
  const auto is_bullet = [](const Vec3& x) { return x.z() > 10; };
  MassPoints points(
      ranks, mesh, [&](GlobalIndex gid) { return static_cast<Rank>(gid * 5 % 7 % ranks.size()); },
      [&](const Vec3& x) { return is_bullet(x) ? 1.0 : 1e6; }, [](const Vec3&) { return Vec3(0, 0, 0); });
  contact::ContactSettings settings;
  settings.specification.rebuild = rebuild;
  contact::Contact contact = points.make_contact(settings);
  constexpr double dt = 0.01;
  for (int step = 0; step < 60; ++step) {
    if (step == 30)
      for (std::size_t n = 0; n < points.x.size(); ++n)
        if (is_bullet(points.mesh.coordinates[n])) points.v[n] = Vec3(40, 25, -700);
    points.step(contact, dt);
  }
  Flight flight{points.all_velocities(), contact.ledger.statistics.searches, 0};
  for (std::size_t n = 0; n < points.x.size(); ++n)
    if (points.mesh.coordinates[n].z() == 40) flight.deepest = std::max(flight.deepest, 0.5 - points.x[n].z());
  flight.deepest = ranks.max(flight.deepest);
  return flight;
}

struct Approach {
  std::vector<double> velocity;  ///< of all nodes at the end, by gid
  contact::ContactStatistics statistics;
};

/// A small block comes down upon a larger one from within reach of the lists, and both drift aside.
Approach approach(const comm::Communicator& ranks, const Rebuild& rebuild) {
  mesh::Mesh mesh;
  support::append_box(mesh, {0, 0, 0}, {4, 4, 1}, {4, 4, 1});
  support::append_box(mesh, {0.7, 0.6, 1.6}, {2, 2, 1}, {2, 2, 1});
  MassPoints points(
      ranks, mesh, [&](GlobalIndex gid) { return static_cast<Rank>(gid * 5 % 7 % ranks.size()); },
      [](const Vec3&) { return 1.0; }, [](const Vec3& x) { return Vec3(0.1, 0, x.z() > 1.5 ? -2.0 : 0.0); });
  contact::ContactSettings settings;
  settings.specification.rebuild = rebuild;
  contact::Contact contact = points.make_contact(settings);
  for (int step = 0; step < 80; ++step) points.step(contact, 0.005);
  return {points.all_velocities(), contact.ledger.statistics};
}

}  // namespace

TEST_CASE("candidates that are known to be apart are not looked at, and nothing is missed by that") {
  const comm::Communicator world = comm::Communicator::world();
  const Approach always = approach(comm::Communicator::self(), {.when = Rebuild::When::every, .steps = 1});
  CHECK(always.statistics.idle_steps == 0);
  CHECK(always.statistics.solved_steps > 0);
  for (const Rebuild& rebuild :
       {Rebuild{}, Rebuild{.when = Rebuild::When::every, .steps = 7}, Rebuild{.when = Rebuild::When::random}}) {
    const Approach lasting = approach(world, rebuild);
    CHECK(lasting.velocity == always.velocity);
    CHECK(lasting.statistics.solved_steps == always.statistics.solved_steps);
    CHECK(lasting.statistics.idle_steps >= 5);
  }
}

TEST_CASE("a suddenly fast body is met as if lists were rebuilt in every step, with far fewer searches") {
  const comm::Communicator world = comm::Communicator::world();
  const Flight always = fly(comm::Communicator::self(), {.when = Rebuild::When::every, .steps = 1});
  CHECK(always.searches >= 60);
  CHECK(always.deepest < 1e-2);  // it did meet the plate, and did not pass
  for (const Rebuild& rebuild :
       {Rebuild{}, Rebuild{.when = Rebuild::When::every, .steps = 1}, Rebuild{.when = Rebuild::When::random}}) {
    const Flight flight = fly(world, rebuild);
    CHECK(flight.velocity == always.velocity);
    CHECK(flight.deepest == always.deepest);
    if (rebuild.when == Rebuild::When::motion_used_up) CHECK(flight.searches <= 40);
  }
}
