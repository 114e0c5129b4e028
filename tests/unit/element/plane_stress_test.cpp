// SPDX-License-Identifier: Apache-2.0
#include "element/plane_stress.hpp"

#include <catch2/catch.hpp>
#include <random>

#include "material/elastic.hpp"
#include "material/j2.hpp"
#include "material/metal.hpp"

using namespace brunt;
using material::J2Response;

namespace {

constexpr double young = 2e11, poisson = 0.3, yield = 3e8;
constexpr double mu = young / (2 * (1 + poisson)), lambda = 2 * mu * poisson / (1 - 2 * poisson);

/// A point under in-plane strain, all lanes the same unless its strain differs.
template <class Response>
struct Point {
  Response law;
  Pack stress[6]{}, tensors[6]{}, scalars[8]{}, normal{};

  explicit Point(const Response& response) : law(response) {
    if constexpr (element::Thermodynamic<Response>)
      for (int i = 0; i < Response::scalars; ++i)
        scalars[i] = broadcast(law.fields()[static_cast<std::size_t>(i)].start);
  }
  /// xx, yy, xy, yz, zx.
  Pack strain(const Pack (&e)[5], double dt = 1e-6) {
    Pack de[6] = {e[0], e[1], Pack{}, e[2], e[3], e[4]};
    const Pack left = element::update_plane_stress(law, dt, de, stress, tensors, scalars);
    normal = de[2];
    return left;
  }
  Pack strain(double xx, double yy, double xy = 0, double yz = 0, double zx = 0) {
    return strain({broadcast(xx), broadcast(yy), broadcast(xy), broadcast(yz), broadcast(zx)});
  }
  [[nodiscard]] double entry(int c) const { return stress[c][0]; }
  [[nodiscard]] double equivalent() const {
    const double x = entry(0), y = entry(1);
    return std::sqrt(x * x + y * y - x * y + 3 * (entry(3) * entry(3) + entry(4) * entry(4) + entry(5) * entry(5)));
  }
};

/// J. C. Simo, R. L. Taylor, Int. J. Numer. Meth. Eng. 22 (1986) 649: return within plane stress, where s1 = (xx + yy)
/// and the other components are divided by 1 + g E/(3 (1 - nu)) and 1 + 2 mu g; g by bisection. No normal strain
/// appears.
struct PlaneReturn {
  double stress[5]{}, p = 0;  // xx, yy, xy, yz, zx
  double hardening;

  void strain(const double (&e)[5]) {
    const double sum = stress[0] + stress[1] + young / (1 - poisson) * (e[0] + e[1]);
    const double difference = stress[0] - stress[1] + 2 * mu * (e[0] - e[1]);
    double shear[3];
    for (int c = 0; c < 3; ++c) shear[c] = stress[2 + c] + 2 * mu * e[2 + c];
    const auto at = [&](double g, double& equivalent) {
      const double a = sum / (1 + g * young / (3 * (1 - poisson))), b = 1 / (1 + 2 * mu * g);
      double q2 = 0.25 * a * a + 0.75 * difference * difference * b * b;
      for (const double s : shear) q2 += 3 * s * s * b * b;
      equivalent = std::sqrt(q2);
      return equivalent - (yield + hardening * (p + 2.0 / 3 * g * equivalent));
    };
    double low = 0, high = 1e3 / mu, q = 0;
    if (at(0, q) > 0) {
      for (int i = 0; i < 200; ++i) {
        const double middle = 0.5 * (low + high);
        (at(middle, q) > 0 ? low : high) = middle;
      }
    } else
      low = 0;
    at(low, q);
    p += 2.0 / 3 * low * q;
    const double a = sum / (1 + low * young / (3 * (1 - poisson))), b = 1 / (1 + 2 * mu * low);
    stress[0] = 0.5 * (a + difference * b);
    stress[1] = 0.5 * (a - difference * b);
    for (int c = 0; c < 3; ++c) stress[2 + c] = shear[c] * b;
  }
};

material::J2 hardened(double hardening) {
  material::J2 constants;
  constants.density = 7850;
  constants.young = young;
  constants.poisson = poisson;
  constants.yield = yield;
  constants.hardening = hardening;
  return constants;
}

material::Metal steel() {
  material::Metal metal;
  metal.density = 7850;
  metal.bulk = lambda + 2.0 / 3 * mu;
  metal.shear = mu;
  metal.strength = material::JohnsonCook{3e8, 5e8, 0.3, 1.0, 293, 1793};
  metal.rate = {material::RateFactor::Form::logarithm, 0.02, 1};
  metal.heat = {450, 0.9, 293};
  return metal;
}

}  // namespace

TEST_CASE("plane stress of an elastic law is Hooke's law of thin plates") {
  Point point(material::ElasticResponse({7850, young, poisson}));
  point.strain(1e-3, -2e-4, 3e-4, 1e-5, -2e-5);
  const double plate = young / (1 - poisson * poisson);
  CHECK(point.entry(0) == Approx(plate * (1e-3 - poisson * 2e-4)).epsilon(1e-12));
  CHECK(point.entry(1) == Approx(plate * (-2e-4 + poisson * 1e-3)).epsilon(1e-12));
  CHECK(point.entry(2) == 0);
  CHECK(point.entry(3) == Approx(2 * mu * 3e-4).epsilon(1e-12));
  CHECK(point.entry(4) == Approx(2 * mu * 1e-5).epsilon(1e-12));
  CHECK(point.entry(5) == Approx(-2 * mu * 2e-5).epsilon(1e-12));
  CHECK(point.normal[0] == Approx(-poisson / (1 - poisson) * 8e-4).epsilon(1e-12));
}

TEST_CASE("plastic plane stress is that of the return of Simo and Taylor, along proportional and other paths") {
  std::mt19937 engine(1);
  std::uniform_real_distribution<double> any(-1, 1);
  for (const double hardening : {0.0, 1e9, 2e10}) {
    Point linear{J2Response<false, false>(hardened(hardening))};
    material::J2 by_table = hardened(0);
    by_table.table = {{0, yield}, {0.01, yield + 0.01 * hardening}, {1, yield + hardening}};
    Point table{J2Response<true, false>(by_table)};
    PlaneReturn direct{{}, 0, hardening};
    double direction[5];
    for (int step = 0; step < 400; ++step) {
      if (step % 20 == 0)
        for (double& c : direction) c = any(engine);
      const double size = step % 7 == 0 ? 2e-3 : 1e-4;
      double e[5];
      for (int c = 0; c < 5; ++c) e[c] = size * direction[c] * (c > 2 ? 0.3 : 1);
      linear.strain(e[0], e[1], e[2], e[3], e[4]);
      table.strain(e[0], e[1], e[2], e[3], e[4]);
      direct.strain(e);
      const int at[5] = {0, 1, 3, 4, 5};
      for (int c = 0; c < 5; ++c) {
        CHECK(std::abs(linear.entry(at[c]) - direct.stress[c]) < 1e-9 * yield);
        CHECK(std::abs(table.entry(at[c]) - direct.stress[c]) < 1e-9 * yield);
      }
      CHECK(linear.scalars[0][0] == Approx(direct.p).epsilon(1e-9));
    }
    CHECK(direct.p > 0.02);
  }
}

// Uniaxial stress: xx prescribed, yy such that its stress vanishes; kinematic hardening H.
TEST_CASE("cyclic uniaxial stress with kinematic hardening has its closed form") {
  const double H = 1e10;
  material::J2 constants = hardened(H);
  constants.kinematic = 1;
  Point point{J2Response<false, true>(constants)};
  const auto pull = [&](double xx) {
    double low = -2e-3, high = 2e-3;
    Point<J2Response<false, true>> trial = point;
    for (int i = 0; i < 100; ++i) {
      trial = point;
      const double yy = 0.5 * (low + high);
      trial.strain(xx, yy);
      (trial.entry(1) > 0 ? high : low) = yy;
    }
    point = trial;
  };
  const double slope = young * H / (young + H), at_yield = yield / young;
  for (int i = 0; i < 10; ++i) pull(1e-3);
  const double top = yield + slope * (0.01 - at_yield);
  CHECK(point.entry(0) == Approx(top).epsilon(1e-8));
  for (int i = 0; i < 20; ++i) pull(-1e-3);
  CHECK(point.entry(0) == Approx(top - 2 * yield - slope * (0.02 - 2 * at_yield)).epsilon(1e-8));
  CHECK(point.entry(2) == 0);
}

TEST_CASE("the law of solids with the normal strain found has no normal stress and the same state, bit for bit") {
  std::mt19937 engine(2);
  std::uniform_real_distribution<double> any(-1, 1);
  const auto follow = [&](auto point) {
    using Response = decltype(point.law);
    double most = 0;
    for (int step = 0; step < 200; ++step) {
      Pack e[5];
      for (Pack& c : e)
        for (int lane = 0; lane < pack_width; ++lane) c[lane] = (step % 3 ? 3e-3 : 2e-4) * any(engine);
      Pack stress[6], tensors[6], scalars[8];
      std::copy_n(point.stress, 6, stress);
      std::copy_n(point.tensors, 6, tensors);
      std::copy_n(point.scalars, 8, scalars);
      point.strain(e);
      const Pack de[6] = {e[0], e[1], point.normal, e[2], e[3], e[4]};
      if constexpr (element::Thermodynamic<Response>)
        point.law.update(de, {1e-6, broadcast(1.0), Pack{}}, stress, scalars);
      else
        point.law.update(de, stress, tensors, scalars);
      for (int lane = 0; lane < pack_width; ++lane) {
        most = std::max(most, std::abs(stress[2][lane]));
        for (const int c : {0, 1, 3, 4, 5}) CHECK(stress[c][lane] == point.stress[c][lane]);
        for (int c = 0; c < Response::scalars; ++c) CHECK(scalars[c][lane] == point.scalars[c][lane]);
      }
    }
    CHECK(most < 1e-11 * young * 3e-3);
    CHECK(point.scalars[0][0] > 0.05);
  };
  material::J2 mixed = hardened(0);
  mixed.table = {{0, yield}, {0.05, 2 * yield}, {0.5, 2.5 * yield}};
  mixed.kinematic = 0.4;
  follow(Point(J2Response<true, true>(mixed)));
  follow(Point(material::MetalResponse<false>(steel())));
  material::Metal table = steel();
  table.strength = material::TableStrength{{{0, yield}, {0.1, 2 * yield}}};
  table.rate = {material::RateFactor::Form::cowper_symonds, 0.2, 40};
  follow(Point(material::MetalResponse<false>(table)));
}

TEST_CASE("a lane of plane stress does not depend on the others") {
  std::mt19937 engine(3);
  std::uniform_real_distribution<double> any(-4e-3, 4e-3);
  Point together{material::MetalResponse<false>(steel())};
  std::vector<Point<material::MetalResponse<false>>> alone(pack_width, together);
  for (int step = 0; step < 50; ++step) {
    Pack e[5];
    for (Pack& c : e)
      for (int lane = 0; lane < pack_width; ++lane) c[lane] = any(engine) * (lane == 3 ? 0.01 : 1);
    together.strain(e);
    for (int lane = 0; lane < pack_width; ++lane) {
      auto& point = alone[static_cast<std::size_t>(lane)];
      point.strain(e[0][lane], e[1][lane], e[2][lane], e[3][lane], e[4][lane]);
      for (int c = 0; c < 6; ++c) CHECK(point.stress[c][0] == together.stress[c][lane]);
      for (int c = 0; c < 4; ++c) CHECK(point.scalars[c][0] == together.scalars[c][lane]);
    }
  }
}

TEST_CASE("a failed point carries nothing in plane stress") {
  material::Metal metal = steel();
  metal.fracture = material::Fracture{};
  metal.fracture->d1 = 0.02;
  Point point{material::MetalResponse<false>(metal)};
  for (int step = 0; step < 60; ++step) point.strain(1e-3, 2e-4, 3e-4, 1e-4, 0);
  CHECK(point.scalars[2][0] == 1);
  for (int c = 0; c < 6; ++c) CHECK(point.entry(c) == 0);
}
