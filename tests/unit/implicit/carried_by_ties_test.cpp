// SPDX-License-Identifier: Apache-2.0
// Ties on walls: slave nodes of a seam that stands on a wall are carried by the tie.
#include <algorithm>
#include <catch2/catch.hpp>

#include "implicit/balance.hpp"
#include "implicit/commit.hpp"
#include "implicit/mortar/mortar.hpp"
#include "support/implicit_system.hpp"
#include "support/side_by_side.hpp"

using namespace brunt;
using namespace brunt::implicit;
using test::Simulation;

namespace {

bool is_seam(const Vec3& X) {
  return X[0] == 1 && X[2] == 0;
}

}  // namespace

TEST_CASE("a tie carries the slave's nodes of a seam on a floor, and its rows are whole") {
  Simulation body = test::side_by_side(", tied: true",
                                       "gravity: {vector: [0, 0, -10]}\n"
                                       "rigid_walls: [{name: floor, point: [0, 0, 0], normal: [0, 0, 1]}]\n");
  const Scene scene{body.model, body.state, body.scratch, body.links};
  Solver solver = make_solver(scene, test::short_steps());
  begin_step(scene, solver, 0.01, 0.01);
  (void)test::residual_at(scene, solver, solver.u);
  const MortarContact& contact = solver.contact;
  const Interface& face = contact.interfaces[0];
  int carried = 0;
  for (const WallNode& node : solver.walls.nodes)
    carried += node.tied.isApprox(Mat3(Vec3(0, 0, 1).asDiagonal())) ? 1 : 0;
  CHECK(carried == 4);
  for (std::size_t row = 0; row < face.count(); ++row)
    if (face.start.tie.covered[row] > 0) CHECK(face.start.tied[row].isIdentity(1e-12));
  for (std::size_t k = 0; k < contact.nodes.lasting; ++k) {
    const bool slave = std::ranges::binary_search(face.surfaces.rows, static_cast<LocalIndex>(k));
    const bool on_floor = contact.nodes.reference[k][2] == 0;
    const bool lifted = slave && is_seam(contact.nodes.reference[k]);
    CHECK(contact.nodes.movable[k](2, 2) == Approx(on_floor && !lifted ? 0 : 1).margin(1e-12));
  }
  CHECK(factorise_tangent(scene, solver).ok());
  CHECK(test::tangent_error(scene, solver, [](std::size_t) { return 1e-6; }) < 1e-6);
}
