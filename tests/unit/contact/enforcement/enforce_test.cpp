// SPDX-License-Identifier: Apache-2.0
// The other formulations of Heinstein et al. 2000 against what their equations give for a lone node, and all of them
// against the exact solution on patches.
#include "brunt/contact/enforcement/enforce.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "problem.hpp"

using namespace brunt;
using namespace brunt::contact;

namespace {

Problem lone_node(double gap, double speed, double mass = 2) {
  Problem p;
  p.add_node(mass, {0, 0, speed});
  p.add_row({{0, 1}}, Vec3::UnitZ()).gap = gap;
  return p;
}

double largest_difference(const Problem& a, const Problem& b) {
  double largest = 0;
  for (std::size_t n = 0; n < a.velocity.size(); ++n)
    largest = std::max(largest, (a.velocity[n] - b.velocity[n]).norm());
  return largest;
}

}  // namespace

TEST_CASE("gap penalty (16): a spring across a penetration, nothing across a gap") {
  Problem p = lone_node(-0.01, -3);
  p.solve({.method = Method::gap_penalty, .stiffness = 0.2}, 0.5);
  CHECK(p.push(0) == Approx(0.2 * 2 * 0.01 / 0.5));
  Problem open = lone_node(1e-9, -3);
  open.solve({.method = Method::gap_penalty, .stiffness = 0.2}, 0.5);
  CHECK(open.push(0) == 0);
  CHECK(step_factor({.method = Method::gap_penalty, .stiffness = 0.4}) == Approx(std::sqrt(0.9)));
  CHECK(step_factor({.method = Method::rate}) == 1);
}

TEST_CASE("gap and rate penalty (20): the spring and a damper on the closing rate") {
  Problem p = lone_node(-0.01, -3);
  p.solve({.method = Method::penalty, .stiffness = 0.2, .damping = 0.1}, 0.5);
  CHECK(p.push(0) == Approx(0.2 * 2 * 0.01 / 0.5 + 0.1 * 2 * 3));
}

TEST_CASE("a penalty bounces elastically within its stable step and grows without bound beyond its limit") {
  const auto energy_after = [](double stiffness) {
    double z = 0.1, v = -1;
    for (int step = 0; step < 400; ++step) {
      Problem p = lone_node(z, v);
      p.solve({.method = Method::gap_penalty, .stiffness = stiffness}, 1.0);
      v = p.velocity[0].z();
      z += v;
    }
    return v;
  };
  CHECK(energy_after(0.05) == Approx(1.0).epsilon(0.02));
  CHECK(std::abs(energy_after(3.0)) < 3);
}

TEST_CASE("partitioned kinematic (24), (25): a lone node ends on the surface, half of it with beta one half") {
  Problem p = lone_node(-0.01, -3);
  p.solve({.method = Method::kinematic}, 0.5);
  CHECK(-0.01 + 0.5 * p.velocity[0].z() == Approx(0).margin(1e-15));
  Problem half = lone_node(-0.01, -3);
  half.solve({.method = Method::kinematic, .partition = 0.5}, 0.5);
  CHECK(-0.01 + 0.5 * half.velocity[0].z() == Approx(0.25 * (-0.01 - 1.5)));  // a half, and a half of what is left
  Problem open = lone_node(0.2, -0.3);
  open.solve({.method = Method::kinematic}, 0.5);
  CHECK(open.push(0) == 0);
}

TEST_CASE("printed H (29): exact for slabs that are the masses, a rebound for slabs that are too heavy") {
  Problem p = lone_node(0, -3);
  p.rows[0].slab = 2 / 0.5;  // slab times dt is the mass
  p.solve({.method = Method::printed, .tolerance = 1e-12, .max_iterations = 1}, 0.5);
  CHECK(std::abs(p.velocity[0].z()) < 1e-14);
  p.rows[0].slab *= 1.8;  // Courant number 0.9 of a matching mesh
  p.solve({.method = Method::printed, .tolerance = 1e-12, .max_iterations = 1}, 0.5);
  CHECK(p.velocity[0].z() == Approx(0.8 * 3));
}

TEST_CASE("all rate methods end at the exact solution") {
  const int scene = GENERATE(0, 1, 2, 3);
  Problem exact = scene == 0   ? patch(20, 13, 1, 1)
                  : scene == 1 ? patch(8, 12, 1, 1)
                  : scene == 2 ? patch(20, 13, 1, 0.1)
                               : random_patch(3);
  const EnforcementResult reference = exact.solve({.method = Method::reference});
  CHECK(reference.residual < 1e-8);
  for (const Method method : {Method::rate, Method::row_sum}) {
    Problem p = exact;
    const EnforcementResult result = p.solve({.method = method, .tolerance = 1e-10, .max_iterations = 100000});
    CHECK(result.residual <= 1e-10);
    CHECK(largest_difference(p, exact) < 1e-6);
  }
}

TEST_CASE("the reference solves rows that hold both ways by conjugate gradients") {
  Problem p = patch(10, 7, 1, 1);
  for (Row& row : p.rows) row.cone = Cone::free;
  const EnforcementResult result = p.solve({.method = Method::reference});
  CHECK(result.residual < 1e-9);
  for (std::size_t q = 0; q < p.rows.size(); ++q) CHECK(std::abs(p.rate(q)) < 1e-9);
}
