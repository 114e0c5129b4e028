// SPDX-License-Identifier: Apache-2.0
// Penalties against what their equations give for a lone node.
#include "contact/enforcement/penalty.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "problem.hpp"

using namespace brunt;
using namespace brunt::contact;

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
