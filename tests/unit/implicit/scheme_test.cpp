// SPDX-License-Identifier: Apache-2.0
// One oscillator, m = 1, force -w^2 u: the schemes against their known amplification and order.
#include "implicit/data/scheme.hpp"

#include <catch2/catch.hpp>
#include <cmath>

using namespace brunt;
using namespace brunt::implicit;
using model::Scheme;

namespace {

struct Oscillator {
  double w = 1, u = 1, v = 0, a = -1;
  model::ImplicitSolver settings;

  Oscillator(Scheme scheme, double alpha, double frequency) : w(frequency), a(-frequency * frequency) {
    settings.scheme = scheme;
    settings.alpha = alpha;
  }
  void step(double dt) {
    const Rule rule = rule_of(settings, dt);
    const double before = -w * w * u;
    const double free = free_travel(rule, Vec3(v, 0, 0), Vec3(a, 0, 0))[0];
    // m (d - free) = now (-w^2 (u + d)) + before F_n for the travel d
    const double d = (rule.mass * free + rule.now * -w * w * u + rule.before * before) / (rule.mass + rule.now * w * w);
    Vec3 acceleration(a, 0, 0);
    v = velocity_after(rule, Vec3(d, 0, 0), Vec3(v, 0, 0), acceleration)[0];
    u += d;
    a = acceleration[0];
  }
  [[nodiscard]] double energy() const { return 0.5 * (v * v + w * w * u * u); }
};

double error_at_one(Scheme scheme, double alpha, int steps) {
  Oscillator body(scheme, alpha, 3);
  for (int n = 0; n < steps; ++n) body.step(1.0 / steps);
  return std::hypot(body.u - std::cos(3.0), (body.v + 3 * std::sin(3.0)) / 3);
}

}  // namespace

TEST_CASE("all schemes are of second order") {
  for (const auto& [scheme, alpha] :
       {std::pair{Scheme::contact_implicit, 0.0}, {Scheme::newmark, 0.0}, {Scheme::hht, 0.1}, {Scheme::hht, 1.0 / 3}}) {
    const double order = std::log2(error_at_one(scheme, alpha, 100) / error_at_one(scheme, alpha, 200));
    CAPTURE(static_cast<int>(scheme), alpha);
    CHECK(order == Approx(2).margin(0.05));
  }
}

TEST_CASE("the trapezoidal rule keeps the energy of a linear oscillator, in steps of any length") {
  for (const Scheme scheme : {Scheme::contact_implicit, Scheme::newmark}) {
    Oscillator body(scheme, 0, 2);
    const double start = body.energy();
    for (int n = 0; n < 1000; ++n) body.step(n % 2 == 0 ? 0.3 : 20.0);
    if (scheme == Scheme::contact_implicit)
      CHECK(body.energy() == Approx(start).epsilon(1e-12));
    else
      CHECK(body.energy() == Approx(start).epsilon(1e-9));  // the acceleration is carried along, and rounds each time
  }
}

TEST_CASE("hht damps what the step does not resolve, and little of what it does") {
  for (const double alpha : {0.05, 1.0 / 3}) {
    Oscillator fast(Scheme::hht, alpha, 1000), slow(Scheme::hht, alpha, 0.1);
    const double slow_start = slow.energy();
    const auto go_on = [&](Oscillator& body) {
      for (int n = 0; n < 100; ++n) body.step(1);
      return body.energy();
    };
    // at infinite frequency the spectral radius is (1 - alpha) / (1 + alpha), of a root twice: amplitudes go with
    // n radius^n (Hilber, Hughes and Taylor 1977)
    const double radius = (1 - alpha) / (1 + alpha);
    const double first = go_on(fast), second = go_on(fast);
    if (alpha < 0.1) CHECK(second < 1.2 * 4 * std::pow(radius, 200) * first);  // else nothing is left
    CHECK(first < 1e-3 * 0.5e6);
    go_on(slow);
    CHECK(slow.energy() > 0.9 * slow_start);
  }
}

TEST_CASE("static states have neither inertia nor memory") {
  model::ImplicitSolver settings;
  settings.scheme = Scheme::statics;
  const Rule rule = rule_of(settings, 0.5);
  CHECK(rule.mass == 0);
  CHECK(rule.now == 1);
  CHECK(rule.before == 0);
  Vec3 acceleration = Vec3::Zero();
  CHECK(free_travel(rule, Vec3(1, 2, 3), acceleration).isZero());
  CHECK(velocity_after(rule, Vec3(1, 0, 0), Vec3(9, 9, 9), acceleration) == Vec3(2, 0, 0));
}
