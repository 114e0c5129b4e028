// SPDX-License-Identifier: Apache-2.0
// A step with contact allocates nothing, but for the steps that rebuild lists.
#include <catch2/catch.hpp>
#include <limits>

#include "tests/support/allocations.hpp"
#include "tests/support/mass_points.hpp"

TEST_CASE("no allocation in a step of contact") {
  using namespace brunt;
  const auto passes = GENERATE(contact::Passes::one, contact::Passes::two, contact::Passes::averaged);
  const double friction = GENERATE(0.0, 0.2);
  const auto tied = GENERATE(contact::Tied::no, contact::Tied::yes);
  const comm::Communicator world = comm::Communicator::world();
  mesh::Mesh mesh;
  support::append_box(mesh, {0, 0, 0}, {4, 4, 1}, {4, 4, 1});
  support::append_box(mesh, {0.3, 0.2, 1.001}, {3.1, 3.3, 0.5}, {6, 6, 1});
  support::MassPoints points(
      world, mesh, [&](GlobalIndex gid) { return static_cast<Rank>(gid % world.size()); },
      [](const Vec3&) { return 1.0; }, [](const Vec3& x) { return Vec3(0, 0, x.z() > 1 ? -1.0 : 0.0); });
  points.walls = {{.point = Vec3(0, 0, -0.02), .normal = Vec3::UnitZ()}};
  points.mesh.blocks.resize(2);
  contact::ContactSettings settings;
  settings.specification.pairs = contact::PairTable(2, {});
  settings.specification.pairs.set(0, 1, {contact::PairRule::automatic, passes, {friction, friction, 0}, tied});
  contact::Contact contact = points.make_contact(settings);
  contact::VelocitySpan unknown;
  unknown.fill(std::numeric_limits<double>::infinity());
  int quiet_steps = 0, solved = 0;
  for (int step = 0; step < 20; ++step) {
    const std::vector<Vec3> old = points.v;
    for (std::size_t n = 0; n < points.x.size(); ++n)
      if (points.mesh.node_gid[n] >= 50) points.v[n].z() -= 0.02;  // soft rows let free points go again
    const contact::StepInput input{.position = {reinterpret_cast<const double*>(points.x.data())},
                                   .old_velocity = {reinterpret_cast<const double*>(old.data())},
                                   .velocity = {reinterpret_cast<double*>(points.v.data())},
                                   .walls = points.walls,
                                   .dt = 0.005};
    const auto searches = contact.ledger.statistics.searches;
    const auto solved_before = contact.ledger.statistics.solved_steps;
    const long start = test::allocations;
    contact::search(contact, input, unknown);
    contact::correct(contact, input);
    const long made = test::allocations - start;
    for (std::size_t n = 0; n < points.x.size(); ++n) points.x[n] += 0.005 * points.v[n];
    if (contact.ledger.statistics.searches != searches || step < 2)
      continue;  // halos make their datatypes at first use
    CHECK(made == 0);
    ++quiet_steps;
    solved += contact.ledger.statistics.solved_steps > solved_before ? 1 : 0;
  }
  CHECK(quiet_steps >= 10);
  CHECK(solved >= 3);  // 4 when this was written: enough to have seen steps with impulses
}
