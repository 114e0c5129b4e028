// SPDX-License-Identifier: Apache-2.0
#include "contact/enforcement/energy_guard.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "random_rows.hpp"

using namespace brunt;
using namespace brunt::contact;

namespace {

/// Energy of each cluster after an iteration that was cut, by everything that holds any: bodies, nodes, compliant rows.
/// Returns the number of clusters whose impulses were scaled.
GlobalIndex cut_iteration(unsigned seed, int iterations, int clusters, bool recovers, Method method) {
  RandomRows p(seed, clusters, recovers);
  const EnforcementResult result = p.solve_boxes({.method = method, .tolerance = 1e-12, .max_iterations = iterations});
  CAPTURE(seed, iterations, clusters, recovers, result.residual, result.least_share, result.scaled_islands);
  for (int c = 0; c < clusters; ++c) {
    const double before = p.energy_of(c, false) + p.stored_in(c, false),
                 after = p.energy_of(c, true) + p.stored_in(c, true);
    CHECK(after <= (1 + 1e-9) * before + (recovers ? p.recovered_in(c) : 0));
  }
  double largest = 1;
  for (const Vec3& impulse : p.impulses) largest = std::max(largest, impulse.norm());
  CHECK(p.momentum_error().norm() <= 1e-12 * largest);
  for (std::size_t q = 0; q < p.rows.size(); ++q)
    CHECK((admitted(p.matrix.laws[q], p.impulses[q]) - p.impulses[q]).norm() <= 1e-12 * largest);
  return result.scaled_islands;
}

void cut_iterations(unsigned variants) {
  GlobalIndex scaled = 0;
  for (unsigned seed = 1; seed <= variants; ++seed)
    for (const int iterations : {1, 5, 50})
      for (const bool recovers : {false, true})
        for (const Method method : {Method::rate, Method::row_sum})
          scaled += cut_iteration(seed, iterations, 1 + static_cast<int>(seed % 3), recovers, method);
  CHECK(scaled > 5);  // or the starts were no test of the guard
}

}  // namespace

TEST_CASE("an iteration cut at 1, 5, 50 gives no energy to any island, and keeps momentum") {
  cut_iterations(10);
}

TEST_CASE("the same for three hundred variants", "[.][long]") {
  cut_iterations(300);
}

TEST_CASE("the largest share without gain, in closed form") {
  CHECK(share_without_gain(-1, 1, 0) == 1);       // E(1) = -1/2
  CHECK(share_without_gain(-1, 2, 0) == 1);       // E(1) = 0: an elastic rebound
  CHECK(share_without_gain(-1, 4, 0) == 0.5);     // theta = -2 linear / quadratic
  CHECK(share_without_gain(1, 4, 0) == 0);        // any share gains
  CHECK(share_without_gain(1, 0, 0.25) == 0.25);  // what was stored allows it
  CHECK(share_without_gain(0, 8, 1) == 0.5);
  CHECK(share_without_gain(0, 0, 0) == 1);
  const double share = share_without_gain(3, 5, 0.7);
  CHECK(3 * share + 2.5 * share * share == Approx(0.7));
}

TEST_CASE("a converged island keeps its impulses where another one is scaled") {
  int seen = 0;
  for (unsigned seed = 1; seed <= 20; ++seed)
    for (const int iterations : {1, 5, 50})
      for (const Method method : {Method::rate, Method::row_sum}) {
        RandomRows p(seed);
        const LocalIndex alone = p.add_node(2, {0, 0, -3});
        p.add_row({{alone, 1}}, Vec3::UnitZ());
        p.impulses.emplace_back(0, 0, 6);
        const EnforcementResult result =
            p.solve_boxes({.method = method, .tolerance = 1e-12, .max_iterations = iterations});
        if (result.scaled_islands == 0) continue;
        ++seen;
        CHECK(p.velocity[static_cast<std::size_t>(alone)].norm() < 1e-14);
      }
  CHECK(seen > 0);
}

TEST_CASE("a driven node and a moving wall may do work on what they meet") {
  // a node at rest is met by a driven one, and another by a wall, both at speed 1: iterations suffice, nothing is
  // scaled
  Problem p;
  const LocalIndex driven = p.add_node(1, {0, 0, 1}), met = p.add_node(2, {0, 0, 0}),
                   by_wall = p.add_node(3, {0, 0, 0});
  p.mobility[static_cast<std::size_t>(driven)].inverse_mass = 0;
  p.add_row({{met, 1}, {driven, -1}}, Vec3::UnitZ());
  Row& row = p.add_row({{by_wall, 1}}, Vec3::UnitZ(), 1);
  row.wall_rate = 1;
  p.impulses = {Vec3(0, 0, 2), Vec3(0, 0, 3)};
  p.velocity.resize(3);
  EnforcementScratch scratch;
  OneRankExchange exchange;
  const System system = p.system();
  EnforcementResult result;
  const auto guard = [&] {
    scratch.compliance.assign(2, 0.0);
    scratch.borne.assign(2, Vec3::Zero());
    apply_impulses(system, p.impulses, 10, exchange, p.velocity, scratch);
    guard_energy(system, exchange, p.impulses, p.velocity, scratch, result);
  };
  guard();
  CHECK(result.scaled_islands == 0);
  CHECK(p.velocity[1].z() == Approx(1));
  CHECK(p.velocity[2].z() == Approx(1));
  // three times the impulse: as seen from the driven node and from the wall they must not leave faster than they came
  p.impulses = {Vec3(0, 0, 6), Vec3(0, 0, 9)};
  guard();
  CHECK(result.scaled_islands == 2);
  CHECK(result.least_share == Approx(2.0 / 3));
  CHECK(p.velocity[1].z() == Approx(2));
  CHECK(p.velocity[2].z() == Approx(2));
}
