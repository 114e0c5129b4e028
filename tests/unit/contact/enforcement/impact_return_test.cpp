// SPDX-License-Identifier: Apache-2.0
#include "contact/enforcement/impact_return.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "problem.hpp"

using namespace brunt;
using namespace brunt::contact;

namespace {

/// A step of rows with states of their own.
struct Returning {
  Problem p;
  EnforcementSettings settings{.tolerance = 1e-9, .max_iterations = 500, .impact = Impact::elastic};
  ImpactScratch impact;
  std::vector<Vec3> rate_impulses, rate_velocity;  ///< of the rate constraint alone
  double rate_kinetic = 0;

  EnforcementResult step(double dt = 1, double transit = 1) {
    OneRankExchange exchange;
    EnforcementScratch scratch;
    p.impulses.assign(p.rows.size(), Vec3::Zero());
    p.velocity.resize(p.motion.size());
    impact.rows.resize(p.rows.size());
    impact.start = p.impulses;
    const System system = p.system();
    EnforcementResult result = enforce(system, settings, dt, exchange, p.impulses, p.velocity, scratch);
    rate_impulses = p.impulses;
    rate_velocity = p.velocity;
    rate_kinetic = p.kinetic(true);
    const std::vector<double> transits(p.motion.size(), transit);
    for (std::size_t q = 0; q < p.rows.size(); ++q) {
      impact.rows[q].transit = transit_of(system.rows, q, transits);
      impact.rows[q].step = impact_step(system, q, transits, dt, p.impulses[q], p.velocity);
    }
    return_at_opening(system, p.matrix, settings, dt, exchange, p.impulses, p.velocity, scratch, impact, result);
    follow_impacts(system, dt, p.impulses, p.velocity, impact);
    return result;
  }
  [[nodiscard]] double offered() const {
    double sum = 0;
    for (const ImpactRow& row : impact.rows) sum += row.offered;
    return sum;
  }
};

/// Two equal bars of N linear elements with lumped masses, as tests/bench/impact_laws.py: restitution, exactly 1.
struct Bars {
  int elements;
  double courant;
  Impact impact;
  double phase;
  double largest_energy = 0;  ///< over that of the start

  double restitution() {
    const double h = 1.0 / elements, speed = 2e-3, dt = courant * h;
    const auto n = static_cast<std::size_t>(elements) + 1;
    std::vector<double> u(2 * n, 0.0), v(2 * n, 0.0), mass(2 * n, h);
    for (const std::size_t end : {std::size_t{0}, n - 1, n, 2 * n - 1}) mass[end] = h / 2;
    std::fill_n(v.begin(), n, speed);
    const double start = speed * dt * (1 + phase);
    ImpactState state;
    for (double t = 0; t < 8; t += dt) {
      std::vector<double> force(2 * n, 0.0), after(2 * n);
      double strain_energy = 0;
      for (std::size_t i = 0; i + 1 < 2 * n; ++i) {
        if (i == n - 1) continue;
        const double stress = (u[i + 1] - u[i]) / h;
        force[i] += stress;
        force[i + 1] -= stress;
        strain_energy += 0.5 * h * stress * stress;
      }
      Returning row;
      row.settings.impact = impact;
      for (std::size_t i = 0; i < 2 * n; ++i) after[i] = v[i] + dt / mass[i] * force[i];
      const double gap = start + u[n] - u[n - 1];
      for (const std::size_t i : {n - 1, n}) {
        row.p.add_node(mass[i], {0, 0, after[i]});
        row.p.motion.back().old_velocity = {0, 0, v[i]};
      }
      row.p.add_row({{1, 1}, {0, -1}}, Vec3::UnitZ(), -std::max(gap, 0.0) / dt).gap = gap;
      row.impact.rows = {{.state = state}};
      row.step(dt, impact == Impact::elastic ? h / 2 : 0);
      state = row.impact.states[0];
      after[n - 1] = row.p.velocity[0].z();
      after[n] = row.p.velocity[1].z();
      double energy = strain_energy;
      for (std::size_t i = 0; i < 2 * n; ++i) {
        energy += 0.5 * mass[i] * v[i] * after[i];
        u[i] += dt * after[i];
      }
      v = after;
      largest_energy = std::max(largest_energy, energy / (0.5 * speed * speed));
    }
    double difference = 0;
    for (std::size_t i = 0; i < n; ++i) difference += mass[i] * (v[n + i] - v[i]);
    return difference / speed;
  }
};

}  // namespace

TEST_CASE("a row alone returns its bank as it opens, and its state is cleared") {
  Returning one;
  one.p = lone_node(0, 0, 2);
  one.impact.rows = {{.state = {.bank = 5, .pressed = 1, .recent = 1, .most = 1, .flow = 0}}};
  const EnforcementResult result = one.step();
  CHECK((result.acted && one.impact.returned));
  CHECK(one.p.kinetic(true) == Approx(5));
  CHECK(one.impact.states[0].flow == -1);
  CHECK(one.p.matrix.laws[0].required == 0);  // as before

  Returning flowed;
  flowed.p = lone_node(0, 0, 2);
  flowed.impact.rows = {{.state = {.bank = 5, .pressed = 1, .recent = 1, .most = 1, .flow = 0.1}}};
  CHECK_FALSE(flowed.step().acted);
  CHECK(flowed.p.kinetic(true) == 0);
}

TEST_CASE("coupled rows give their bodies no more than they took, and momentum stays") {
  for (unsigned seed = 1; seed <= 30; ++seed)
    for (const double friction : {0.0, 0.3}) {
      Returning patched;
      patched.p = random_patch(seed);
      if (seed % 2 == 0) patched.p = patch(6, 5, 1, 2, seed);
      const std::size_t rows = patched.p.rows.size();
      double banked = 0;
      for (std::size_t q = 0; q < rows; ++q) {
        patched.p.rows[q].friction = friction;
        const double bank = q % 3 == seed % 3 ? 0.0 : 0.1 * static_cast<double>(1 + q % 5);
        patched.impact.rows.push_back({.state = {.bank = bank, .pressed = 1, .recent = 1, .most = 1, .flow = 0}});
      }
      const EnforcementResult result = patched.step();
      CAPTURE(seed, friction, result.iterations, result.residual, patched.offered());
      double along = 0;  // work along the normals beyond that of the rate constraint
      for (std::size_t q = 0; q < rows; ++q) {
        const ImpactRow& row = patched.impact.rows[q];
        banked += row.state.bank;
        along += 0.5 * patched.p.push(q) * (row.step.before + patched.p.rate(q)) -
                 0.5 * row.step.push * (row.step.before + row.step.after);
      }
      CHECK(along <= patched.offered() * (1 + 1e-9));
      CHECK(patched.offered() <= banked);
      const double given = patched.p.kinetic(true) - patched.rate_kinetic;
      CHECK(patched.impact.returned);
      if (friction == 0) CHECK(given > 0.2 * patched.offered());  // friction takes more where bodies part faster
      CHECK(given <= patched.offered() * (1 + 1e-9));
      CHECK(patched.p.momentum_change().norm() < 1e-10);
      for (std::size_t q = 0; q < rows; ++q) {
        CHECK(patched.p.push(q) >= 0);
        CHECK(patched.p.rate(q) >= patched.p.rows[q].required - 1e-6);
        CHECK((patched.p.impulses[q] - patched.p.push(q) * patched.p.rows[q].normal).norm() <=
              friction * patched.p.push(q) + 1e-12);
      }
    }
}

TEST_CASE("islands without a row that opens keep their bits, and so does all where nothing is offered") {
  Returning both;
  both.p = random_patch(5);
  const LocalIndex alone = both.p.add_node(2, Vec3::Zero());
  both.p.add_row({{alone, 1}}, Vec3::UnitZ());
  both.impact.rows.assign(both.p.rows.size(), {});
  both.impact.rows.back().state = {.bank = 3, .pressed = 1, .recent = 1, .most = 1, .flow = 0};
  both.step();
  CHECK(both.impact.returned);
  for (std::size_t q = 0; q + 1 < both.p.rows.size(); ++q) CHECK(both.p.impulses[q] == both.rate_impulses[q]);
  CHECK(both.p.kinetic(true) - both.rate_kinetic == Approx(3));

  Returning none;
  none.p = random_patch(5);
  none.step();
  CHECK_FALSE(none.impact.returned);
  CHECK(none.p.impulses == none.rate_impulses);
  CHECK(none.p.velocity == none.rate_velocity);
}

TEST_CASE("equal elastic bars rebound as in theory with few elements, and never with more energy") {
  for (const int elements : {1, 2, 4}) {
    double plastic = 0, elastic = 0, least = 1;
    int runs = 0;
    for (const double courant : {0.9, 0.5})
      for (double phase = 0.03; phase < 1; phase += 0.07, ++runs) {
        Bars bars{elements, courant, Impact::elastic, phase};
        const double restitution = bars.restitution();
        elastic += restitution;
        least = std::min(least, restitution);
        CAPTURE(elements, courant, phase, restitution);
        CHECK(bars.largest_energy <= 1 + 1e-12);
        plastic += Bars{elements, courant, Impact::plastic, phase}.restitution();
      }
    CAPTURE(elements);
    // theory: 1, and sqrt(1 - 1/(2N)) less what remains in waves; the figures of impact_laws.py
    CHECK(elastic / runs == Approx(0.98).margin(0.006));
    CHECK(least > 0.91);
    CHECK(plastic / runs == Approx(elements == 1 ? 0.50 : elements == 2 ? 0.74 : 0.86).margin(0.006));
  }
}
