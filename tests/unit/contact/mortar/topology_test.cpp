// SPDX-License-Identifier: Apache-2.0
// Reference areas of slave nodes.
#include <catch2/catch.hpp>
#include <numeric>

#include "evaluation.hpp"

using namespace brunt;
using namespace brunt::contact;
using test::TwoSurfaces;

TEST_CASE("Reference areas of the nodes add up to the surface, and equal the weights where all is covered") {
  const auto askew = [](double height) {
    return [height](double x, double y) { return Vec3(x + 0.3 * x * y, y - 0.2 * x * y * y, height); };
  };
  for (const bool triangles : {false, true}) {
    const TwoSurfaces two({3, 2, 0, 1, 0, 1, true, triangles}, askew(0), {2, 2, -1, 2, -0.5, 2, false, false},
                          askew(0.1));
    const test::Evaluation evaluation(two);
    CHECK(evaluation.topology.edge > 0.3);
    CHECK(evaluation.topology.edge < 0.6);
    for (std::size_t row = 0; row < two.surfaces.rows.size(); ++row)
      CHECK(evaluation.topology.kappa[row] * evaluation.rows.covered[row] == Approx(1).epsilon(1e-6));
  }
  const TwoSurfaces square(
      {4, 4, 0, 1, 0, 1, true, false}, [](double x, double y) { return Vec3(x, y, 0); },
      {1, 1, 0, 1, 0, 1, false, false}, [](double x, double y) { return Vec3(x, y, 0.1); });
  const MortarTopology topology = make_topology(square.surfaces, square.x);
  CHECK(1 / topology.kappa[0] == Approx(1.0 / 64).epsilon(1e-14));
  CHECK(1 / topology.kappa[6] == Approx(1.0 / 16).epsilon(1e-14));
  CHECK(topology.edge == Approx(0.25).epsilon(1e-14));
  CHECK(topology.facets_around.row(6).size() == 4);
}
