// SPDX-License-Identifier: Apache-2.0
// When contact is made, and exact sums that go through a checkpoint unchanged.
#include "app/state/contact_setup.hpp"

#include <catch2/catch.hpp>

#include "prepared_scene.hpp"

using namespace brunt;

TEST_CASE("contact setup: no contact is made where the scene has none, walls alone search no bodies") {
  CHECK(support::PreparedScene(support::two_bodies).run->contact == nullptr);
  const support::PreparedScene walls(support::two_bodies +
                                     "rigid_walls: [{name: w, point: [0, 0, 0], normal: [0, 0, 1]}]\n");
  REQUIRE(walls.run->contact);
  CHECK(walls.run->contact->ledger.sums.wall_impulse.size() == 1);
}

TEST_CASE("contact setup: sums come back from what a checkpoint holds, bit for bit") {
  support::PreparedScene scene(support::two_bodies +
                               "contact: [{between: all}]\nprobes: [{name: p, contact: [low, top]}]\n");
  REQUIRE(scene.run->contact);
  REQUIRE(scene.run->tracked.size() == 1);
  contact::Contact& contact = *scene.run->contact;
  const comm::Communicator self = comm::Communicator::self();
  for (const double term : {1e20, 1.0, -1e20, 1e-20, 0.1}) {
    contact.ledger.sums.work.contact.add(term);
    contact.ledger.sums.tracked[0].impulse[2].add(-term);
  }
  contact.ledger.sums.penetration = 0.25;
  const std::vector<double> saved = app::save_sums(self, contact);
  contact.ledger.sums.work.contact.add(17);
  contact.ledger.sums.tracked[0].impulse[2].clear();
  contact.ledger.sums.penetration = 3;
  CHECK(app::save_sums(self, contact) != saved);
  app::restore_sums(self, saved, contact);
  CHECK(app::save_sums(self, contact) == saved);
  const contact::ContactTotals totals = contact::collect(contact);
  CHECK(totals.contact_work == 1.1);  // 1 + 0.1 + 1e-20, rounded once
  CHECK(totals.tracked[0].impulse == Vec3(0, 0, -1.1));
  CHECK(totals.penetration == 0.25);
}
