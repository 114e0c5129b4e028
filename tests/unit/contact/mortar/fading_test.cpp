// SPDX-License-Identifier: Apache-2.0
// Shares of pairs that enter or leave rows.
#include "contact/mortar/fading.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "facet_pairs.hpp"

using namespace brunt;
using namespace brunt::contact;
using test::Corners;

namespace {

constexpr double reach = 0.4;  // capture distance

bool integrated(const Corners& slave, const Corners& master, bool fading, SegmentIntegrals& integrals,
                SegmentSlopes* slopes) {
  SlavePlane plane;
  if (!make_slave_plane(slave, plane) || !integrate_segment(plane, master, 2 * reach, integrals, slopes)) return false;
  if (fading) fade(plane, master, reach, integrals, slopes);
  return true;
}

}  // namespace

TEST_CASE("Pairs enter and leave without a jump, and derivatives of their share are those of differences") {
  const auto tilted = [](double angle, double height) {  // about the y axis, looking down at angle 0
    Corners corners = test::unit_square;
    std::reverse(corners.begin() + 1, corners.end());
    for (Vec3& x : corners)
      x = Vec3(std::cos(angle) * x[0] + 0.05, 0.9 * x[1] + 0.1 * x[0] + 0.03,
               std::sin(angle) * x[0] + height);  // no side on a side
    return corners;
  };
  const double degree = std::acos(-1.0) / 180;
  for (const auto& [angle, height] : {std::pair{70.0, -0.3}, std::pair{10.0, 0.2}, std::pair{66.0, -0.6}}) {
    const Corners slave = test::unit_square, master = tilted(angle * degree, height);
    SegmentIntegrals integrals, whole;
    SegmentSlopes slopes;
    CAPTURE(angle, height);
    REQUIRE(integrated(slave, master, false, whole, nullptr));
    REQUIRE(integrated(slave, master, true, integrals, &slopes));
    CHECK(integrals.area < 0.99 * whole.area);
    CHECK(integrals.area > 0.01 * whole.area);
    const double step = 1e-6;
    for (int direction = 0; direction < 24; ++direction) {
      const auto corner = static_cast<std::size_t>(direction % 12 / 3);
      const auto at = [&](double move) {
        Corners moved[2] = {slave, master};
        moved[direction / 12][corner][direction % 3] += move;
        SegmentIntegrals there;
        REQUIRE(integrated(moved[0], moved[1], true, there, nullptr));
        return test::products_of(there);
      };
      const auto plus = at(step), minus = at(-step);
      const auto d = static_cast<std::size_t>(direction);
      for (std::size_t a = 0; a < 4; ++a)
        for (std::size_t b = 0; b < 4; ++b) {
          const double of_slave = (plus[4 * a + b] - minus[4 * a + b]) / (2 * step),
                       of_master = (plus[16 + 4 * a + b] - minus[16 + 4 * a + b]) / (2 * step);
          CHECK(slopes.slave[SegmentSlopes::pair_of_corners(a, b)][d] == Approx(of_slave).margin(2e-8));
          CHECK(slopes.master[a][b][d] == Approx(of_master).margin(2e-8));
        }
    }
  }
  SegmentIntegrals last;  // at the limits themselves nothing is left
  REQUIRE(integrated(test::unit_square, tilted(78.4 * degree, -0.4), true, last, nullptr));
  CHECK(last.area < 1e-5);
  REQUIRE(integrated(test::unit_square, tilted(0, 0.3999), true, last, nullptr));
  CHECK(last.area < 1e-6);
}
