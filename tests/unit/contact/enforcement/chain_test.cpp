// SPDX-License-Identifier: Apache-2.0
// Light bodies between heavy ones in motion: an impact is inelastic, whatever the masses, contact gives no energy, and
// the light body is not squeezed in. Stacks at rest need no more iterations by it.
#include <catch2/catch.hpp>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <random>

#include "box_chain.hpp"

using namespace brunt;
using namespace brunt::contact;

namespace {

constexpr double speed = 10;

struct Seen {
  double rebound = 0;  ///< largest speed upwards / speed of the impact
  double energy = 0;   ///< largest / at the start
};

Seen run(BoxChain& chain, int steps) {
  Seen seen;
  const double start = chain.energy();
  for (int k = 0; k < steps; ++k) {
    chain.step();
    for (const Box& box : chain.p.boxes) seen.rebound = std::max(seen.rebound, box.velocity.z() / speed);
    seen.energy = std::max(seen.energy, chain.energy() / start);
  }
  return seen;
}

/// Two to four boxes of random sizes and masses on the floor (or in the air), not quite in line; the last one falls.
BoxChain random_chain(unsigned seed, bool on_floor) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> part(0, 1);
  BoxChain chain;
  chain.friction = seed % 2 == 0 ? 0.0 : 0.3;
  const int boxes = 2 + static_cast<int>(seed % 3);
  for (int b = 0; b < boxes; ++b) {
    const bool last = b + 1 == boxes;
    chain.add({.size = Vec3::Constant(0.3 + part(random)),
               .mass = std::pow(10.0, 3 * part(random)),
               .velocity = {0, 0, last ? -speed : 0.0}},
              last ? 0.005 + 0.02 * part(random) : 0, Vec3(0.1 * part(random), 0.1 * part(random), 0));
  }
  chain.lay_rows(on_floor);
  return chain;
}

/// CHECK for many: worst figures in one message.
void check_random_chains(unsigned variants, double most_rebound) {
  Seen worst;
  double deepest = 0;
  unsigned of_rebound = 0;
  for (unsigned seed = 1; seed <= variants; ++seed) {
    BoxChain chain = random_chain(seed, true);
    const Seen seen = run(chain, 40);
    if (seen.rebound > worst.rebound) of_rebound = seed;
    worst.rebound = std::max(worst.rebound, seen.rebound);
    worst.energy = std::max(worst.energy, seen.energy);
    deepest = std::max(deepest, chain.deepest / 0.3);
  }
  CAPTURE(of_rebound);
  CHECK(worst.rebound < most_rebound);
  CHECK(worst.energy <= 1 + 1e-9);
  CHECK(deepest < 0.033);  // of the smallest box: what it travels in a step; seen: 0.031 of 300
  if (std::getenv("BRUNT_MEASURE") != nullptr)
    std::cout << variants << " chains: rebound " << worst.rebound << ", energy " << worst.energy << ", depth "
              << deepest << '\n';
}

}  // namespace

TEST_CASE("a ram falls on a pin on the floor: no rebound at any ratio of their masses, and the pin stays whole") {
  const double ratio = GENERATE(1e-2, 1.0, 10.0, 100.0, 1e3, 1e6), friction = GENERATE(0.0, 0.3);
  BoxChain chain;
  chain.friction = friction;
  chain.add({.size = {0.4, 0.4, 0.4}, .mass = 1}, 0);
  chain.add({.size = {1, 1, 1}, .mass = ratio, .velocity = {0, 0, -speed}}, 0.05);
  chain.lay_rows(true);
  const Seen seen = run(chain, 60);
  CAPTURE(ratio, friction, chain.most_iterations);
  CHECK(seen.rebound < 0.04);
  CHECK(seen.energy <= 1 + 1e-9);
  CHECK(chain.deepest < 0.02 * 0.4);
  CHECK((chain.at_limit == 0 || ratio > 1e3));
}

TEST_CASE("random chains of boxes on the floor: no rebound, no energy, no depth") {
  check_random_chains(10, 0.05);
}

TEST_CASE("the same for three hundred chains", "[.][long]") {
  check_random_chains(300, 0.15);  // seen: 0.12, four boxes
}

TEST_CASE("random chains in the air go on together, with the momentum they had") {
  for (unsigned seed = 1; seed <= 10; ++seed) {
    BoxChain chain = random_chain(seed, false);
    const Vec3 start = chain.momentum();
    const Seen seen = run(chain, 40);
    double mass = 0;
    for (const Box& box : chain.p.boxes) mass += box.mass;
    CAPTURE(seed);
    CHECK((chain.momentum() - start).norm() <= 1e-12 * start.norm());
    CHECK(seen.energy <= 1 + 1e-9);
    CHECK(chain.deepest < 0.03 * 0.3);
  }
}

TEST_CASE("stacks of boxes at rest, equal ones and mixed: iterations") {
  const auto [boxes, mixed, most] = GENERATE(std::tuple(2, false, 10.0), std::tuple(6, false, 30.0),
                                             std::tuple(10, false, 40.0), std::tuple(6, true, 60.0));
  BoxChain chain;
  std::mt19937 random(3);
  std::uniform_real_distribution<double> part(0, 1);
  chain.gravity = {0, 0, -10};
  chain.friction = 0.5;
  for (int b = 0; b < boxes; ++b)
    chain.add({.size = {0.1, 0.1, 0.1}, .mass = mixed ? std::pow(10.0, 2 * part(random)) : 1}, 1e-9 * part(random),
              {0.004 * std::sin(b), 0.003 * std::cos(b), 0});
  chain.dt = 1e-4;
  chain.longest_recovery = 1e-4;
  chain.lay_rows(true);
  for (int k = 0; k < 300; ++k) chain.step();
  const double mean = static_cast<double>(chain.iterations) / chain.steps;
  CAPTURE(boxes, mixed, mean, chain.most_iterations);
  CHECK(mean <= most);
  CHECK(chain.at_limit == 0);
  if (std::getenv("BRUNT_MEASURE") != nullptr)
    std::cout << boxes << (mixed ? " mixed" : " equal") << " boxes: " << mean << " iterations, at most "
              << chain.most_iterations << '\n';
}
