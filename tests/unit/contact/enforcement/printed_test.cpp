// SPDX-License-Identifier: Apache-2.0
// The printed H against slabs that are, and are not, the masses.
#include "contact/enforcement/printed.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "problem.hpp"

using namespace brunt;
using namespace brunt::contact;

TEST_CASE("printed H (29): exact for slabs that are the masses, a rebound for slabs that are too heavy") {
  Problem p = lone_node(0, -3);
  p.rows[0].slab = 2 / 0.5;  // slab times dt is the mass
  p.solve({.method = Method::printed, .tolerance = 1e-12, .max_iterations = 1}, 0.5);
  CHECK(std::abs(p.velocity[0].z()) < 1e-14);
  p.rows[0].slab *= 1.8;  // Courant number 0.9 of a matching mesh
  p.solve({.method = Method::printed, .tolerance = 1e-12, .max_iterations = 1}, 0.5);
  CHECK(p.velocity[0].z() == Approx(0.8 * 3));
}
