// SPDX-License-Identifier: Apache-2.0
#include "support/element_bench.hpp"

namespace brunt::test {

Corners<8> unit_cube() {
  Corners<8> X;
  X << 0, 1, 1, 0, 0, 1, 1, 0,  //
      0, 0, 1, 1, 0, 0, 1, 1,   //
      0, 0, 0, 0, 1, 1, 1, 1;
  return X;
}

Corners<8> distorted_cube(std::mt19937& engine, double size) {
  std::uniform_real_distribution<double> shift(-size, size);
  return unit_cube() + Corners<8>::NullaryExpr([&] { return shift(engine); });
}

}  // namespace brunt::test
