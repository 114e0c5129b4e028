// SPDX-License-Identifier: Apache-2.0
// Records are due at the first step at or past each multiple of their interval, whatever the steps.
#include "app/run/schedule.hpp"

#include <catch2/catch.hpp>

using namespace brunt;

namespace {

model::State at(double step, double before, double now) {
  model::State state;
  state.step = step;
  state.time_before = before;
  state.time = now;
  return state;
}

/// Records of a run in steps of dt.
int records(double dt, int steps, const scene::Input& input) {
  int count = 0;
  for (int n = 0; n < steps; ++n) count += app::history_due(at(n, n > 0 ? (n - 1) * dt : 0, n * dt), input) ? 1 : 0;
  return count;
}

}  // namespace

TEST_CASE("schedule: due at t = 0 and at the first step at or past each multiple, once however many are passed") {
  CHECK(app::due(at(0, 0, 0), 0.25));
  CHECK_FALSE(app::due(at(1, 0, 0.24), 0.25));
  CHECK(app::due(at(2, 0.24, 0.26), 0.25));
  CHECK_FALSE(app::due(at(3, 0.26, 0.49), 0.25));
  CHECK(app::due(at(4, 0.49, 1.6), 0.25));
  CHECK_FALSE(app::due(at(5, 1.6, 1.74), 0.25));
  CHECK_FALSE(app::due(at(0, 0, 0), std::nullopt));
}

TEST_CASE("schedule: history as the scene says, else some 200 rows by time or by steps") {
  scene::Input input;
  input.run.end = 1.0;
  CHECK(records(1.0 / 1024, 1024, input) == 200);
  CHECK(records(1.0 / 64, 64, input) == 13);  // every fifth step, no more
  input.history_every = 0.125;
  CHECK(records(1.0 / 1024, 1024, input) == 8);

  scene::Input by_steps;
  by_steps.run.steps = 1000;
  CHECK(records(0.1, 1000, by_steps) == 200);
  by_steps.run.steps = 7;
  CHECK(records(0.1, 7, by_steps) == 2);
}

TEST_CASE("schedule: end, overshoot and share of a run") {
  scene::Run run;
  run.end = 2.0;
  CHECK_FALSE(app::at_end(at(5, 1, 1.5), run));
  CHECK(app::progress(at(5, 1, 1.5), run) == 0.75);
  CHECK(app::overshoot(at(5, 1, 1.5), run) == 0);
  CHECK(app::at_end(at(6, 1.5, 2.5), run));
  CHECK(app::overshoot(at(6, 1.5, 2.5), run) == 0.25);
  CHECK(app::progress(at(6, 1.5, 2.5), run) == 1);
  run.steps = 5;
  CHECK(app::at_end(at(5, 1, 1.5), run));
  run.end.reset();
  CHECK(app::overshoot(at(6, 1.5, 2.5), run) == 0);
}

TEST_CASE("schedule: time left is told by the speed since this start, not by what was done before it") {
  CHECK(app::seconds_left(10, 0, 0.25) == Approx(30));
  CHECK(app::seconds_left(10, 0.9, 0.95) == Approx(10));  // after a restart
  CHECK(app::seconds_left(10, 0.5, 0.5) == 0);            // nothing to tell yet
}
