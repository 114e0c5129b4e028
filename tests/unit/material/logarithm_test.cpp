// SPDX-License-Identifier: Apache-2.0
#include "material/logarithm.hpp"

#include <catch2/catch.hpp>
#include <random>

using namespace brunt;

TEST_CASE("logarithm of a pack agrees with the library's to two units in the last place") {
  std::mt19937 engine(1);
  std::uniform_real_distribution<double> power(-300, 300), near_one(-0.5, 1.0), tiny(-1e-6, 1e-6);
  double worst = 0;
  for (int sample = 0; sample < 100000; ++sample) {
    const double a = sample % 3 == 0 ? std::pow(10.0, power(engine)) : 1 + (sample % 3 == 1 ? near_one : tiny)(engine);
    Pack pack = broadcast(1.0);
    pack[sample % pack_width] = a;
    const Pack result = material::pack_log(pack);
    const double reference = std::log(a);
    if (reference != 0) worst = std::max(worst, std::abs(result[sample % pack_width] / reference - 1));
    REQUIRE(result[(sample + 1) % pack_width] == 0);
  }
  CHECK(worst < 4.5e-16);
}

TEST_CASE("logarithm of what is not positive is not a number") {
  const Pack result = material::pack_log(Pack{1, 0, -1, -1e300});
  CHECK(result[0] == 0);
  CHECK(std::isnan(result[1]));
  CHECK(std::isnan(result[2]));
  CHECK(std::isnan(result[3]));
}
