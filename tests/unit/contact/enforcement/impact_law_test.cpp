// SPDX-License-Identifier: Apache-2.0
#include "contact/enforcement/impact_law.hpp"

#include <catch2/catch.hpp>
#include <limits>
#include <random>

using namespace brunt::contact;

TEST_CASE("a row opens as its pressing force falls to less than half, or where nothing presses it") {
  const ImpactState pressed{.bank = 1, .pressed = 4, .recent = 4, .most = 4, .flow = 0};
  const auto step = [](double pressing, double push, double after) {
    return ImpactStep{.before = 0, .after = after, .push = push, .pressing = pressing};
  };
  CHECK(opens(pressed, step(1.9, 1, 0)));
  CHECK_FALSE(opens(pressed, step(2.1, 1, 0)));
  CHECK(opens(pressed, step(2.1, 0, 2)));        // its neighbours separate it
  CHECK_FALSE(opens(pressed, step(2.1, 0, 0)));  // pressed, but the others of several redundant rows hold it
  CHECK(opens({.bank = 1, .flow = 0}, step(0, 0, 0)));
  CHECK_FALSE(opens({.bank = 0, .pressed = 4, .flow = 0}, step(0, 0, 1)));  // it has taken nothing
  CHECK_FALSE(opens({.bank = -1, .pressed = 4, .flow = 0}, step(0, 0, 1)));
}

TEST_CASE("the bank is returned unless the elements flow or the load has been removed slowly") {
  ImpactState state{.bank = 8, .pressed = 1, .recent = 3, .most = 4, .flow = 0.02};
  CHECK(energy_to_return(state, 0.02) == 8);  // 4 phi / top - 2 = 1
  CHECK(energy_to_return(state, 0.02 + 1e-12) == 0);
  CHECK(energy_to_return(state, 0.01) == 0);  // an element has been removed
  CHECK(energy_to_return(state, std::numeric_limits<double>::infinity()) == 0);
  state.recent = 2.5;
  CHECK(energy_to_return(state, 0.02) == Approx(4));
  state.recent = 2;
  CHECK(energy_to_return(state, 0.02) == 0);
  CHECK(energy_to_return({.bank = 8, .flow = 0}, 0) == 8);  // it never was pressed
  CHECK(energy_to_return({.bank = 8, .flow = std::numeric_limits<double>::infinity()},
                         std::numeric_limits<double>::infinity()) == 0);  // a material without a plastic strain
  CHECK(energy_to_return({.bank = -8, .flow = 0}, 0) == 0);
}

TEST_CASE("a row alone does exactly the work that it returns") {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> rate(-3, 3), size(0.01, 5);
  for (int i = 0; i < 200; ++i) {
    const ImpactStep step{.before = rate(random), .after = rate(random), .push = i % 3 == 0 ? 0.0 : size(random)};
    const double answer = size(random), energy = size(random);
    const double after = returning_rate(step, energy, answer), push = step.push + (after - step.after) / answer;
    CAPTURE(i, step.before, step.after, step.push, answer, energy, after);
    CHECK(after > step.after);
    CHECK(0.5 * push * (step.before + after) - 0.5 * step.push * (step.before + step.after) == Approx(energy));
  }
  CHECK(returning_rate({.before = 1, .after = 2, .push = 3}, 0, 4) == 2);
}

TEST_CASE("a row that stays closed takes, gives and remembers") {
  const ImpactStep first{.before = -2, .after = 0, .push = 3, .pressing = 0, .flow = 0.5};
  ImpactState state = closed_state({}, first, 0.5 * 3 * -2, 0.1);
  CHECK(state.bank == 3);
  CHECK(state.flow == 0.5);
  state = closed_state(state, {.pressing = 4, .flow = 0.7}, 1, 0.1);
  CHECK(state.bank == 2);
  CHECK(state.flow == 0.5);  // that of the arrival
  CHECK((state.pressed == 4 && state.recent == 4 && state.most == 4));
  state = closed_state(state, {.pressing = 2}, 3, 0.1);
  CHECK(state.bank == -1);  // a row that has given more than it took owes it
  CHECK((state.pressed == 2 && state.most == 4));
  CHECK(state.recent == Approx(3.8));
  CHECK(closed_state(state, {.pressing = 1}, 0, 7).recent == 1);
}
