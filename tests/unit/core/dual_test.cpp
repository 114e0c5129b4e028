// SPDX-License-Identifier: Apache-2.0
#include "core/dual.hpp"

#include <catch2/catch.hpp>

using namespace brunt;

namespace {

/// Of a function written once, called with packs and with duals: values agree, slopes with central differences.
template <class Function>
void check(const Function& f, double at) {
  Pack direction;
  for (int lane = 0; lane < pack_width; ++lane) direction[lane] = lane - 1.5;
  const Dual result = f(Dual(broadcast(at), direction));
  const double h = 1e-6;
  const double slope = (f(broadcast(at + h))[0] - f(broadcast(at - h))[0]) / (2 * h);
  for (int lane = 0; lane < pack_width; ++lane) {
    CHECK(result.value[lane] == Approx(f(broadcast(at))[lane]).epsilon(1e-15));
    CHECK(result.slope[lane] == Approx(slope * direction[lane]).epsilon(1e-8).margin(1e-9));
  }
}

}  // namespace

TEST_CASE("sums, products and quotients of duals, packs and constants have the slopes of calculus") {
  check([](auto x) { return (2.0 * x - 1.0) * (x + 3.0) - x * x * x; }, 0.7);
  check([](auto x) { return (1.0 - x) / (2.0 + x * x) + 1.0 / x - x; }, 0.7);
  check([](auto x) { return x * broadcast(3.0) / broadcast(0.5) - broadcast(2.0) * x + (broadcast(1.0) - x); }, 0.7);
  check([](auto x) { return -x + broadcast(1.0) + (x - broadcast(2.0)); }, 0.7);
  check(
      [](auto x) {
        auto y = x;
        y += x * x;
        y *= x;
        y -= 1.0 / x;
        y /= 2.0 + x;
        return y;
      },
      0.7);
}

TEST_CASE("roots and choices of duals") {
  check([](auto x) { return pack_sqrt(1.0 + x * x); }, 0.7);
  check([](auto x) { return pack_max(x * x, 0.5 * x) + pack_min(x, 2.0 * x); }, 0.2);
  check([](auto x) { return pack_max(x * x, 0.5 * x) + pack_min(x, 2.0 * x); }, -0.7);
  check([](auto x) { return select(x > broadcast(0.5), x * x, 3.0 * x); }, 0.7);
  const Dual root = pack_sqrt(Dual(broadcast(0.0), broadcast(1.0)));  // taken to be at its least
  CHECK(root.value[0] == 0);
  CHECK(root.slope[0] == 0);
}
