// SPDX-License-Identifier: Apache-2.0
#include "implicit/step_length.hpp"

#include <catch2/catch.hpp>

using namespace brunt;
using namespace brunt::implicit;

namespace {

model::ImplicitSolver solver(double step, double least, double most) {
  model::ImplicitSolver settings;
  settings.step = step;
  settings.min_step = least;
  settings.max_step = most;
  return settings;
}

}  // namespace

TEST_CASE("halved steps meet the times of unhalved ones again") {
  const model::ImplicitSolver settings = solver(0.1, 0.1 / 1024, 0.1);
  StepLength length;
  for (int n = 0; n < 3; ++n) count_step(settings, 3, length);
  REQUIRE(halve(settings, length));
  REQUIRE(halve(settings, length));
  CHECK(step_of(settings, length) == 0.025);
  CHECK(time_of(settings, length) == 3 * 0.1);
  CHECK(next_time(settings, length) == 13 * 0.025);
  int steps = 0;
  while (step_of(settings, length) < 0.1 && steps < 100) {
    count_step(settings, 3, length);
    ++steps;
  }
  CHECK(steps == 2 + 3);  // to 0.35 by quarters; by halves to 0.45, in the middle of a whole one, and to 0.5
  CHECK(next_time(settings, length) == 6 * 0.1);
}

TEST_CASE("hard steps keep the length, easy ones double it up to the largest") {
  const model::ImplicitSolver settings = solver(1, 0.25, 4);
  StepLength length;
  for (int n = 0; n < 10; ++n) count_step(settings, easy_iterations + 1, length);
  CHECK(step_of(settings, length) == 1);
  CHECK(length.count == 10);
  for (int n = 0; n < 40; ++n) count_step(settings, easy_iterations, length);
  CHECK(step_of(settings, length) == 4);
}

TEST_CASE("no step below the least one, though that is given in decimals") {
  const model::ImplicitSolver settings = solver(0.3, 0.075, 0.3);
  StepLength length;
  CHECK(halve(settings, length));
  CHECK(halve(settings, length));
  CHECK_FALSE(halve(settings, length));
  CHECK(step_of(settings, length) == 0.075);
}
