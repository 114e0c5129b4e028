// SPDX-License-Identifier: Apache-2.0
#include "element/hex8.hpp"

#include <catch2/catch.hpp>
#include <cstring>
#include <numbers>

#include "material/elastic.hpp"
#include "material/j2.hpp"
#include "material/neo_hookean.hpp"
#include "support/element_bench.hpp"

using namespace brunt;
using element::Hex8;
using element::HourglassKind;
using material::ElasticResponse;
using test::Corners;
using test::ElementBench;
using test::Matrix;

namespace {

constexpr element::BulkViscosity no_viscosity{0, 0};
constexpr element::Hourglass stiff{HourglassKind::stiffness, 0.05};

template <HourglassKind kind>
using Elastic = Hex8<ElasticResponse, kind>;

template <HourglassKind kind>
ElementBench<Elastic<kind>> elastic_bench(const Corners<8>& X, double poisson = 0.3, double coefficient = 0.05) {
  return {Elastic<kind>{ElasticResponse({1, 1, poisson}), {kind, coefficient}, no_viscosity}, X, 1};
}

Matrix rotation(double angle) {
  return Eigen::AngleAxisd(angle, Eigen::Vector3d(1, -2, 0.5).normalized()).toRotationMatrix();
}

long zero_modes(const Eigen::VectorXd& found) {
  return (found.array().abs() < 1e-8).count();
}

/// Distorted, slender and sheared elements.
Corners<8> random_element(std::mt19937& engine, int sample) {
  Corners<8> X = test::distorted_cube(engine, 0.003 * (sample % 100));
  const double aspect[] = {1, 0.3, 0.05, 10};
  X.row(2) *= aspect[sample % 4];
  X.row(1) *= aspect[sample / 4 % 3];
  if (sample % 5 == 0) X.row(0) += 0.8 * X.row(1);
  return rotation(sample) * X;
}

}  // namespace

// E = 1, nu = 0.3: assembled independently from the shape functions.
TEST_CASE("one-point cube has the textbook eigenvalues, and 18 modes without energy but 6 with hourglass control") {
  const Corners<8> X = test::unit_cube();
  const Eigen::VectorXd bare = test::eigenvalues(elastic_bench<HourglassKind::none>(X).stiffness(X));
  CHECK(zero_modes(bare) == 18);
  for (int i = 18; i < 23; ++i) CHECK(bare[i] == Approx(1 / 2.6).epsilon(1e-8));
  CHECK(bare[23] == Approx(1.25).epsilon(1e-8));
  const Eigen::VectorXd controlled = test::eigenvalues(elastic_bench<HourglassKind::stiffness>(X).stiffness(X));
  CHECK(zero_modes(controlled) == 6);
  for (int i = 18; i < 24; ++i) CHECK(controlled[i] == Approx(bare[i]).epsilon(1e-8));
}

TEST_CASE("a distorted element has the same count of modes without energy") {
  std::mt19937 engine(1);
  const Corners<8> X = test::distorted_cube(engine, 0.2);
  CHECK(zero_modes(test::eigenvalues(elastic_bench<HourglassKind::none>(X).stiffness(X))) == 18);
  CHECK(zero_modes(test::eigenvalues(elastic_bench<HourglassKind::stiffness>(X).stiffness(X))) == 6);
}

TEMPLATE_TEST_CASE_SIG("hourglass control does not answer to a linear field on a distorted element", "",
                       ((HourglassKind kind), kind), HourglassKind::stiffness, HourglassKind::viscous) {
  std::mt19937 engine(2);
  for (int sample = 0; sample < 20; ++sample) {
    const Corners<8> X = random_element(engine, sample);
    const Matrix gradient = test::random_matrix(engine, 1e-2);
    auto bare = elastic_bench<HourglassKind::none>(X);
    auto controlled = elastic_bench<kind>(X, 0.3, 1.0);
    const Corners<8> x = X + gradient * X;
    const Corners<8> difference = controlled.move(X, x).force - bare.move(X, x).force;
    CHECK(difference.norm() < 1e-12 * (bare.move(x, x).force.norm() + (x - X).norm()));  // impedance 1
  }
}

TEST_CASE("hourglass forces turn with the element, in steps of 10 degrees, and take no energy from a rotation") {
  std::mt19937 engine(3);
  const Corners<8> X = test::distorted_cube(engine, 0.1);
  const Corners<8> bent = X + test::distorted_cube(engine, 0.05) - test::unit_cube();
  auto bench = elastic_bench<HourglassKind::stiffness>(X);
  bench.move(X, bent);
  const Corners<8> force = bench.move(bent, bent).force;
  const auto energy = [&] { return bench.history[Elastic<HourglassKind::stiffness>::at_hourglass_energy][0]; };
  const double stored = energy();
  CHECK(stored > 0);
  for (int step = 1; step <= 36; ++step) {
    const double angle = std::numbers::pi / 18;
    const Corners<8> now = bench.move(rotation((step - 1) * angle) * bent, rotation(step * angle) * bent).force;
    CHECK((now - rotation(step * angle) * force).norm() < 1e-13);
  }
  CHECK(energy() == Approx(stored).epsilon(1e-12));
}

// Seen from the element, the rate of the hourglass force must not lean to one side of the motion: with a part of first
// order in the step's rotation a spinning body loses its energy to hourglass modes.
TEST_CASE("an hourglass motion during a rotation gives the turned force to second order in the step") {
  std::mt19937 engine(4);
  const Corners<8> X = test::unit_cube();
  const Corners<8> mode = test::distorted_cube(engine, 0.02) - X;
  const auto error = [&](int steps) {
    auto turning = elastic_bench<HourglassKind::stiffness>(X), still = turning;
    Corners<8> before = X, before_still = X;
    for (int i = 1; i <= steps; ++i) {
      const Corners<8> bent = X + static_cast<double>(i) / steps * mode, now = rotation(0.5 * i / steps) * bent;
      turning.move(before, now);
      still.move(before_still, bent);
      before = now;
      before_still = bent;
    }
    const Corners<8> expected = rotation(0.5) * still.move(before_still, before_still).force;
    return (turning.move(before, before).force - expected).norm() / expected.norm();
  };
  CHECK(error(40) < 1e-4);
  CHECK(std::log2(error(20) / error(40)) == Approx(2).margin(0.2));
}

// The hourglass forces are what stresses deviate from their mean within the element: flow brings them back with it.
TEST_CASE(
    "plastic flow returns hourglass forces with the stress deviator; without flow, or if elastic, they keep every "
    "bit") {
  using Plastic = Hex8<material::J2Response<false, false>, HourglassKind::stiffness>;
  std::mt19937 engine(5);
  const Corners<8> X = test::unit_cube();
  const auto mises = [](const Matrix& s) { return std::sqrt(1.5) * (s - s.trace() / 3 * Matrix::Identity()).norm(); };
  for (const double yield : {1.0, 0.02}) {
    material::J2 law;
    law.density = law.young = 1;
    law.poisson = 0.3;
    law.yield = yield;
    law.hardening = 0.1;
    ElementBench<Plastic> plastic{Plastic{material::J2Response<false, false>(law), stiff, no_viscosity}, X, 1};
    ElementBench<Plastic> unlimited{
        Plastic{material::J2Response<false, false>(law), {HourglassKind::elastic, 0.05}, no_viscosity}, X, 1};
    auto elastic = elastic_bench<HourglassKind::stiffness>(X);
    const Corners<8> bent = test::distorted_cube(engine, 0.1);
    plastic.move(X, bent);
    unlimited.move(X, bent);
    elastic.move(X, bent);
    const double left = mises(plastic.stress()) / mises(elastic.stress());
    CAPTURE(yield, left);
    CHECK((yield < 1 ? left < 0.9 : left == 1));
    for (std::size_t c = 0; c < 12; ++c) {
      const double trial = elastic.history[Elastic<HourglassKind::stiffness>::at_hourglass_force + c][0];
      const double force = plastic.history[Plastic::at_hourglass_force + c][0];
      CHECK(unlimited.history[Plastic::at_hourglass_force + c][0] == trial);
      if (yield < 1)
        CHECK(force == Approx(left * trial).epsilon(1e-12));
      else
        CHECK(force == trial);
    }
  }
}

TEST_CASE("the step bound is safe for negative Poisson's ratios, where lambda is negative") {
  std::mt19937 engine(11);
  for (const double poisson : {-0.2, -0.5, -0.9})
    for (const double size : {0.0, 0.15}) {
      const Corners<8> X = test::distorted_cube(engine, size);
      auto bench = elastic_bench<HourglassKind::none>(X, poisson);
      const double rate = bench.move(X, X).rate;
      // eight corners share the mass 1 of the element
      const double exact = std::sqrt(8 * test::eigenvalues(bench.stiffness(X)).maxCoeff());
      CAPTURE(poisson, size, exact);
      CHECK(2 * rate >= exact * (1 - 1e-6));
    }
}

TEST_CASE("the step bound is exact for cubes where A10 asks, and safe for any free element and its exact eigenvalue") {
  // a free unit cube, step times cp/h: exact values of the element eigenvalue problem
  const double table[3][2] = {{0, 1}, {0.3, 0.7337993857053426}, {0.45, 0.6158817620514397}};
  for (const auto& [poisson, step] : table) {
    auto bench = elastic_bench<HourglassKind::none>(test::unit_cube(), poisson);
    const ElasticResponse& law = bench.kernel.law;
    CHECK(std::sqrt(law.lambda + 2 * law.mu) / bench.move(test::unit_cube(), test::unit_cube()).rate ==
          Approx(step).epsilon(1e-12));
  }
  std::mt19937 engine(5);
  int tried = 0;
  double loosest = 0;
  for (int sample = 0; sample < 400; ++sample) {
    const Corners<8> X = random_element(engine, sample);
    // a coefficient far above the usual one, so that hourglass modes are sometimes the stiffest
    const double coefficient = sample % 3 == 0 ? 0.05 : sample % 3 == 1 ? 1.0 : 8.0;
    auto bench = elastic_bench<HourglassKind::stiffness>(X, 0.1 * (sample % 5), coefficient);
    Matrix prestress = test::random_matrix(engine, 0.05 * (sample % 2));
    bench.set_stress(0.5 * (prestress + prestress.transpose()));
    const auto answer = bench.move(X, X);
    if (!(answer.volume > 0)) continue;
    const double exact = 0.5 * std::sqrt(8 * test::eigenvalues(bench.stiffness(X)).maxCoeff());
    CAPTURE(sample, coefficient, answer.rate / exact);
    CHECK(answer.rate >= exact * (1 - 1e-6));
    if (sample % 6 == 0) loosest = std::max(loosest, answer.rate / exact);
    ++tried;
  }
  CHECK(tried > 300);
  CHECK(loosest < 1.5);  // the usual coefficient, no prestress
}

TEMPLATE_TEST_CASE("what an element answers does not depend on its lane or on the others in the batch", "",
                   (Hex8<ElasticResponse, HourglassKind::stiffness>), (Hex8<ElasticResponse, HourglassKind::viscous>),
                   (Hex8<material::J2Response<false, false>, HourglassKind::stiffness>),
                   (Hex8<material::J2Response<true, true>, HourglassKind::stiffness>),
                   (Hex8<material::NeoHookeanResponse, HourglassKind::stiffness>)) {
  using Kernel = TestType;
  const auto response = [] {
    if constexpr (std::is_same_v<decltype(Kernel::law), ElasticResponse>)
      return ElasticResponse({1, 1, 0.3});
    else if constexpr (std::is_same_v<decltype(Kernel::law), material::NeoHookeanResponse>)
      return material::NeoHookeanResponse({1, 1, 0.4});
    else if constexpr (std::is_same_v<decltype(Kernel::law), material::J2Response<true, true>>)
      return material::J2Response<true, true>({1, 1, 0.3, 0, 0, {{0, 0.01}, {0.1, 0.02}}, 0.5});
    else
      return material::J2Response<false, false>({1, 1, 0.3, 0.01, 0.1, {}, 0});
  }();
  const Kernel kernel{response, stiff, {0.06, 1.2}};

  std::mt19937 engine(6);
  std::uniform_real_distribution<double> entry(-0.05, 0.05);
  double x[8][24], v[8][24], memory[8][Kernel::history_size];  // eight elements
  for (int e = 0; e < 8; ++e) {
    const Corners<8> X = test::unit_cube();
    for (int c = 0; c < 24; ++c) {
      x[e][c] = X(c / 8, c % 8) + entry(engine);
      v[e][c] = entry(engine);
    }
    for (double& value : memory[e]) value = 0.1 * std::abs(entry(engine));
    memory[e][0] = 1;
  }
  /// Bits of element e's answer with element order[lane] in each lane.
  const auto answer = [&](const int(&order)[pack_width], int lane) {
    element::BatchMotion<8> in;
    in.dt = 1;
    std::vector<Pack> history(Kernel::history_size);
    for (int l = 0; l < pack_width; ++l) {
      const int e = order[l];
      for (int c = 0; c < 24; ++c) {
        in.x[c / 8][c % 8][l] = x[e][c];
        in.v[c / 8][c % 8][l] = v[e][c];
        in.X[c / 8][c % 8][l] = test::unit_cube()(c / 8, c % 8);
      }
      for (std::size_t h = 0; h < history.size(); ++h) history[h][l] = memory[e][h];
    }
    element::BatchForce<8> out;
    kernel(in, history.data(), history.data(), out);
    std::vector<double> bits{out.rate[lane], out.volume[lane]};
    for (int c = 0; c < 24; ++c) bits.push_back(out.f[c / 8][c % 8][lane]);
    for (const Pack& value : history) bits.push_back(value[lane]);
    return bits;
  };
  int in_order[pack_width];
  for (int l = 0; l < pack_width; ++l) in_order[l] = l;
  for (int e = 0; e < pack_width; ++e) {
    const std::vector<double> expected = answer(in_order, e);
    for (int shift = 1; shift < pack_width; ++shift) {
      int order[pack_width];
      for (int l = 0; l < pack_width; ++l) order[l] = (l * 5 + shift) % 8;
      order[(e + shift) % pack_width] = e;
      const std::vector<double> found = answer(order, (e + shift) % pack_width);
      CHECK(std::memcmp(expected.data(), found.data(), expected.size() * sizeof(double)) == 0);
    }
    int alone[pack_width];
    for (int& of_lane : alone) of_lane = e;
    const std::vector<double> padded = answer(alone, 3);
    CHECK(std::memcmp(expected.data(), padded.data(), expected.size() * sizeof(double)) == 0);
  }
}
