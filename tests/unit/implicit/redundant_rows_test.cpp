// SPDX-License-Identifier: Apache-2.0
// Rows that nothing can satisfy have no multiplier.
#include <algorithm>
#include <catch2/catch.hpp>

#include "implicit/solver.hpp"
#include "support/side_by_side.hpp"

using namespace brunt;
using namespace brunt::implicit;
using test::Simulation;

TEST_CASE("rows of contact that no node can follow have no multiplier") {
  Simulation body = test::side_by_side("", "fixed: [{part: left, dofs: [x]}, {part: right, dofs: [y]}]\n");
  const Scene scene{body.model, body.state, body.scratch, body.links};
  Solver solver = make_solver(scene, test::short_steps());
  MortarContact& contact = solver.contact;
  const auto pressed = [&] {  // rows of nodes of edges yield to others
    std::ptrdiff_t count = 0;
    for (const Interface& face : contact.interfaces)
      if (!face.of_points) count += std::ranges::count(face.iterate.active, std::uint8_t{1});
    return count;
  };
  for (Interface& face : contact.interfaces)
    for (std::size_t row = 0; row < face.count(); ++row)
      face.iterate.active[row] = face.iterate.rows.covered[row] > 0 ? 1 : 0;
  const auto all = pressed();
  REQUIRE(all == 16);
  leave_out_redundant(body.links.ranks, contact.nodes.free, contact);
  CHECK(pressed() == all);
  const std::vector<Mat3> movable(contact.nodes.lasting, Vec3(0, 1, 1).asDiagonal());
  leave_out_redundant(body.links.ranks, movable, contact);
  CHECK(pressed() == 0);
}
