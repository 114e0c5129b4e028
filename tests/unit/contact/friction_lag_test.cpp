// SPDX-License-Identifier: Apache-2.0
#include <array>
#include <catch2/catch.hpp>
#include <cmath>

#include "contact/anchors/friction.hpp"
#include "contact/data/row_matrix.hpp"

using namespace brunt;
using contact::LimitRecord, contact::Row;

namespace {

constexpr double coefficient = 0.4, lag = 0.5;

Row rubbing(GlobalIndex slave, GlobalIndex face) {
  return {.key = {.slave = slave, .master = face}, .normal = {0, 0, 1}, .friction = coefficient};
}

/// A node that comes into touch and is pressed with 1 for a time of `lag`, then with 2, on one face and then on the
/// next, beside another one that does not press it: its limit after both times.
std::array<double, 2> limit_after_lags(int steps) {
  const double dt = lag / steps;
  std::vector<LimitRecord> limits;
  std::array<double, 2> force{};
  for (int step = 0; step < 2 * steps; ++step) {
    std::vector<Row> rows{rubbing(7, step % 5), rubbing(7, 6)};
    for (Row& row : rows) let_friction_lag(row, limits, lag, dt);
    const double push = (step < steps ? 1 : 2) * dt;
    const Vec3 impulse = admitted(law_of(rows[0]), {100, 0, push});
    CHECK(impulse.z() == push);
    force[step < steps ? 0 : 1] = impulse.x() / dt;
    write_limits(rows, std::vector<Vec3>{impulse, Vec3::Zero()}, dt, limits);
  }
  return force;
}

}  // namespace

TEST_CASE("friction that lags follows jumps of the pressure as exp(-t / lag), to first order in the step") {
  const double first = coefficient * (1 - std::exp(-1)),
               second = 2 * coefficient + (first - 2 * coefficient) * std::exp(-1);
  const auto coarse = limit_after_lags(50), fine = limit_after_lags(100);
  CHECK(std::abs(fine[0] - first) < 4e-3 * coefficient);
  CHECK(std::abs(fine[1] - second) < 4e-3 * coefficient);
  CHECK((coarse[0] - first) / (fine[0] - first) == Approx(2).epsilon(0.05));
  CHECK((coarse[1] - second) / (fine[1] - second) == Approx(2).epsilon(0.05));
}

TEST_CASE("friction that lags: nothing without pressure, its limit remains while the row is there, and goes with it") {
  std::vector<LimitRecord> limits{{.key = {.slave = 7}, .limit = 3}};
  std::vector<Row> rows{rubbing(7, 0)};
  let_friction_lag(rows[0], limits, lag, 0.1);
  CHECK(admitted(law_of(rows[0]), {5, 0, -1}).isZero(0));
  write_limits(rows, std::vector<Vec3>{Vec3::Zero()}, 0.1, limits);
  REQUIRE(limits.size() == 1);
  CHECK(limits[0].limit == Approx(3 * lag / (lag + 0.1)));
  write_limits({}, {}, 0.1, limits);
  CHECK(limits.empty());
  std::vector<Row> open{rubbing(7, 0), rubbing(8, 0)};
  open[0].lags = true;  // the other one does not lag
  write_limits(open, std::vector<Vec3>{Vec3::Zero(), {0, 0, 1}}, 0.1, limits);
  CHECK(limits.empty());
}

TEST_CASE("limits of friction stand in order of their keys, the mean where a node has several rows on a body") {
  std::vector<Row> rows{rubbing(2, 1), rubbing(2, 3), rubbing(2, 4), rubbing(9, 0)};
  rows[2].key.kind = contact::RowKind::wall;
  for (Row& row : rows) row.lags = true;
  std::vector<LimitRecord> limits;
  write_limits(rows, std::vector<Vec3>{{0, 0, 1}, {0, 0, 2}, {0, 0, 5}, {0, 0, 7}}, 1, limits);
  REQUIRE(limits.size() == 3);
  CHECK((limits[0].key.slave == 2 && limits[0].key.kind == contact::RowKind::wall));
  CHECK(limits[0].limit == Approx(5 * coefficient));
  CHECK(limits[1].limit == Approx(1.5 * coefficient));
  CHECK((limits[2].key.slave == 9 && limits[2].limit == Approx(7 * coefficient)));
}
