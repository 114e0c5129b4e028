// SPDX-License-Identifier: Apache-2.0
#include "material/exponential.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <random>

using namespace brunt;

TEST_CASE("the exponential of packs is that of the library to two units in the last place", "[oracle]") {
  std::mt19937 engine(1);
  std::uniform_real_distribution<double> argument(-699, 699), small(-1e-3, 1e-3);
  double worst = 0;
  for (int k = 0; k < 20000; ++k) {
    Pack a;
    for (int lane = 0; lane < pack_width; ++lane) a[lane] = k % 2 == 0 ? argument(engine) : small(engine);
    const Pack value = material::pack_exp(a);
    for (int lane = 0; lane < pack_width; ++lane) {
      const double exact = std::exp(a[lane]);
      worst = std::max(worst, std::abs(value[lane] - exact) / exact);
    }
  }
  CHECK(worst < 4.5e-16);
  CHECK(material::pack_exp(Pack{})[0] == 1);
  CHECK(std::isnan(material::pack_exp(broadcast(std::nan("")))[0]));
}

TEST_CASE("powers of packs are those of the library, zero of zero", "[oracle]") {
  for (const double b : {0.1, 0.26, 0.5, 1.0, 1.09, 3.0})
    for (const double a : {1e-12, 1e-4, 0.3, 1.0, 7.5})
      CHECK(material::pack_power(broadcast(a), b)[0] == Approx(std::pow(a, b)).epsilon(1e-14));
  CHECK(material::pack_power(Pack{}, 0.3)[0] == 0);
}
