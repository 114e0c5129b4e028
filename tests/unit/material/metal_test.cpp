// SPDX-License-Identifier: Apache-2.0
#include "material/metal.hpp"

#include <array>
#include <catch2/catch.hpp>
#include <cmath>

#include "support/metal_point.hpp"

using namespace brunt;
using material::Metal;
using test::Matrix;
using Point = test::MetalPoint<material::MetalResponse<false>>;
using ShockPoint = test::MetalPoint<material::MetalResponse<true>>;

namespace {

Metal steel(material::JohnsonCook strength, double rate_c, double capacity, double density, double young,
            double poisson) {
  Metal law;
  law.density = density;
  law.shear = young / (2 * (1 + poisson));
  law.bulk = young / (3 * (1 - 2 * poisson));
  law.strength = strength;
  law.rate = {material::RateFactor::Form::logarithm, rate_c, 1};
  law.heat = {capacity, 0.9, strength.room};
  return law;
}

// OFHC copper, Armco iron, 4340, 42CrMo4: constants and table of a9_johnson_cook_flow.csv
const std::array<Metal, 4> metals{steel({90e6, 292e6, 0.31, 1.09, 294, 1356}, 0.025, 383, 8960, 124e9, 0.34),
                                  steel({175e6, 380e6, 0.32, 0.55, 294, 1811}, 0.06, 452, 7890, 207e9, 0.29),
                                  steel({792e6, 510e6, 0.26, 1.03, 294, 1793}, 0.014, 477, 7830, 200e9, 0.29),
                                  steel({806e6, 614e6, 0.168, 1.1, 20, 1540}, 0.0089, 460, 7830, 206.9e9, 0.3)};

/// Pure shear at a constant rate of the equivalent strain until the plastic strain `end`.
void shear_to(Point& point, double rate, double end, double step) {
  const double dt = step / rate;
  Matrix before = Matrix::Identity();
  for (int steps = 0; point.scalar(0) < end && steps < 1.2 * end / step + 100; ++steps) {
    // volume-preserving stretch along x, contraction along y: equivalent strain 2/sqrt(3) ln stretch
    const double missing = end - point.scalar(0), now = std::min(step, missing < step ? missing + 1e-12 : step);
    const double stretch = std::exp(0.5 * std::sqrt(3.0) * now);
    Matrix after = before;
    after(0, 0) *= stretch;
    after(1, 1) /= stretch;
    point.deform(before, after, dt * now / step);
    before = after;
  }
}

}  // namespace

TEST_CASE("Johnson-Cook flow follows the table of four metals at three rates, isothermal and adiabatic", "[oracle]") {
  // metal, rate [1/s], plastic strain, isothermal [MPa], T [K; C], adiabatic [MPa]
  const double table[][6] = {{0, 1, 0.5, 325.539393693, 328.967572171, 317.655818756},
                             {0, 1, 1, 382, 373.702350853, 359.291357529},
                             {0, 1e3, 1, 447.969062914, 386.954650621, 416.477963496},
                             {0, 1e5, 0.1, 300.082642956, 300.714072613, 298.879880316},
                             {0, 1e5, 1, 491.94843819, 395.704031748, 453.803012337},
                             {1, 1, 0.5, 479.406553484, 340.26599744, 409.09026191},
                             {1, 1e3, 1, 785.02825079, 430.108731076, 576.588517707},
                             {1, 1e5, 1, 938.380417984, 453.419453973, 666.589718423},
                             {2, 1, 1, 1302, 557.902102637, 1084.41876456},
                             {2, 1e3, 0.5, 1335.67571195, 436.687986672, 1217.19589368},
                             {2, 1e5, 1, 1511.85760538, 596.034493778, 1221.52658011},
                             {3, 1, 1, 1420, 324.786552768, 1177.53124652},
                             {3, 1e3, 1, 1507.30021122, 341.6441525, 1234.2232637},
                             {3, 1e5, 1, 1565.50035203, 352.764499415, 1271.07452098}};
  for (const auto& [metal, rate, strain, isothermal, temperature, adiabatic] : table) {
    Metal law = metals[static_cast<std::size_t>(metal)];
    CAPTURE(metal, rate, strain);
    Point hot{material::MetalResponse<false>(law)};
    shear_to(hot, rate, strain, 1e-3);
    CHECK(test::equivalent(hot.cauchy()) == Approx(adiabatic * 1e6).epsilon(2e-4));
    CHECK(hot.scalar(1) == Approx(temperature).epsilon(2e-4));
    law.heat.capacity = 0;
    Point cold{material::MetalResponse<false>(law)};
    shear_to(cold, rate, strain, 1e-3);
    CHECK(test::equivalent(cold.cauchy()) == Approx(isothermal * 1e6).epsilon(2e-4));
  }
}

TEST_CASE("the temperature of adiabatic flow is of second order in the step", "[oracle]") {
  Metal law = metals[2];
  law.rate.form = material::RateFactor::Form::none;
  const auto final = [&](double step) {
    Point point{material::MetalResponse<false>(law)};
    shear_to(point, 1, 0.4, step);
    return point.scalar(1);
  };
  const double coarse = final(0.04), middle = final(0.02), fine = final(0.01);
  const double order = std::log2(std::abs((coarse - middle) / (middle - fine)));
  CAPTURE(coarse, middle, fine);
  CHECK(order > 1.2);  // the first step has an infinite slope of hardening, p^0.26
}

TEST_CASE("flow stops at the melting point", "[law]") {
  Metal law = metals[0];
  law.heat.start = 1400;
  Point point{material::MetalResponse<false>(law)};
  shear_to(point, 1e3, 0.1, 1e-3);
  CHECK(test::equivalent(point.cauchy()) < 1);
}

TEST_CASE("Cowper-Symonds multiplies the table by 1 + (rate / D)^(1/p)", "[oracle]") {
  Metal law = metals[2];
  law.strength = material::TableStrength{{{0, 300e6}, {0.1, 400e6}, {1, 490e6}}};
  law.rate = {material::RateFactor::Form::cowper_symonds, 1 / 5.0, 40.4};
  Point point{material::MetalResponse<false>(law)};
  shear_to(point, 1000, 0.5, 1e-3);
  CHECK(test::equivalent(point.cauchy()) == Approx(440e6 * (1 + std::pow(1000 / 40.4, 0.2))).epsilon(1e-4));
}

TEST_CASE("damage grows with the strain at fracture of the triaxiality", "[oracle]") {
  Metal law = metals[2];
  law.heat.capacity = 0;
  law.rate.form = material::RateFactor::Form::none;
  law.fracture =
      material::Fracture{0.05, 3.44, -2.12, 0.61, {material::RateFactor::Form::logarithm, 0.002, 1}, 1, false};
  Point point{material::MetalResponse<false>(law)};
  shear_to(point, 1000, 0.5, 1e-3);  // no mean stress: e_f = D1 + D2
  const double fracture = (0.05 + 3.44) * (1 + 0.002 * std::log(1000));
  CHECK(point.scalar(2) == Approx(0.5 / fracture).epsilon(2e-3));
  shear_to(point, 1000, fracture * 1.01, 1e-3);
  CHECK(point.scalar(0) == Approx(fracture).epsilon(2e-3));
  CHECK(point.scalar(2) == 1);
  CHECK(test::equivalent(point.cauchy()) == 0);
}

TEST_CASE("no lane of a return depends on the others", "[law]") {
  const material::Strength strength(metals[2]);
  material::FlowStart start{};
  for (int lane = 0; lane < pack_width; ++lane) {
    start.equivalent[lane] = 1e6 * std::pow(10, 0.5 * lane);
    start.plastic_strain[lane] = lane % 2 == 0 ? 0.0 : 0.01 * lane;
  }
  start.temperature = broadcast(300);
  start.scale = broadcast(1);
  const material::FlowEnd all = strength.close(start, strength.yield(start));
  for (int lane = 0; lane < pack_width; ++lane) {
    const material::FlowStart one{broadcast(start.equivalent[lane]),
                                  broadcast(start.plastic_strain[lane]),
                                  broadcast(300),
                                  broadcast(1),
                                  Pack{},
                                  0};
    const material::FlowEnd alone = strength.close(one, strength.yield(one));
    CHECK(alone.increment[0] == all.increment[lane]);
    CHECK(alone.yield[0] == all.yield[lane]);
    const double rest = start.equivalent[lane] - 3 * metals[2].shear * alone.increment[0] - alone.yield[0];
    if (alone.increment[0] > 0) CHECK(std::abs(rest) < 2e-13 * start.equivalent[lane]);
    material::FlowStart after = one;
    after.plastic_strain += alone.increment;
    CHECK(alone.yield[0] == Approx(strength.yield(after).value[0]).epsilon(1e-11));
  }
}

namespace {

Metal shocked(double density, double c, double s, double gamma) {
  Metal law;
  law.density = density;
  law.bulk = density * c * c;
  law.strength = material::LinearStrength{0, 0, 0};
  law.eos = material::EquationOfState{material::EquationOfState::Model::mie_gruneisen, c, s, gamma, {}, 0, 0};
  return law;
}

Matrix ball(double volume) {
  return std::cbrt(volume) * Matrix::Identity();
}

/// The pressure at a state: that of a step without a change of volume.
Pack pressure_at(const material::PressureLaw& eos, Pack volume, Pack energy) {
  return eos.close(volume, Pack{}, Pack{}, energy, PackMask{}).pressure;
}

}  // namespace

TEST_CASE("Mie-Gruneisen: states on the Hugoniot have its pressure", "[oracle]") {
  // density, c, s, gamma; up, density behind, pressure [GPa], energy [J/kg] (a9_hugoniot.csv)
  const double table[][8] = {{8930, 3940, 1.489, 1.99, 500, 9997.03309834, 20.9162925, 125000},
                             {8930, 3940, 1.489, 1.99, 2000, 12561.5575437, 123.55548, 2000000},
                             {2703, 5350, 1.34, 2.0, 500, 2947.83695652, 8.13603, 125000},
                             {7830, 4569, 1.49, 2.17, 1000, 9377.73670686, 47.44197, 500000},
                             {19220, 4030, 1.237, 1.54, 500, 21536.4999397, 44.672085, 125000}};
  for (const auto& [density, c, s, gamma, up, behind, pressure, energy] : table) {
    const Metal law = shocked(density, c, s, gamma);
    const material::PressureLaw eos(*law.eos, density);
    const Pack J = broadcast(density / behind);
    CHECK(pressure_at(eos, J, broadcast(energy * density))[0] == Approx(pressure * 1e9).epsilon(1e-10));
  }
}

TEST_CASE("slow compression follows the isentrope to 1e-6, of second order in the step", "[oracle]") {
  // de/dJ = -p with p = cold(J) + gamma e: integrated by Runge-Kutta of fourth order with 20000 steps
  const Metal law = shocked(8930, 3940, 1.489, 1.99);
  const material::PressureLaw eos(*law.eos, law.density);
  const double end = 0.8;
  const auto p = [&](double J, double e) { return pressure_at(eos, broadcast(J), broadcast(e))[0]; };
  double e = 0;
  const int fine = 20000;
  const double h = (end - 1) / fine;
  for (int k = 0; k < fine; ++k) {
    const double J = 1 + k * h;
    const double k1 = -p(J, e), k2 = -p(J + h / 2, e + h / 2 * k1), k3 = -p(J + h / 2, e + h / 2 * k2),
                 k4 = -p(J + h, e + h * k3);
    e += h / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
  }
  const double exact = p(end, e);
  const auto reached = [&](int steps) {
    ShockPoint point{material::MetalResponse<true>(law)};
    for (int k = 0; k < steps; ++k)
      point.deform(ball(1 + k * (end - 1) / steps), ball(1 + (k + 1) * (end - 1) / steps), 1e-3);
    return point.pressure();
  };
  CHECK(reached(2000) == Approx(exact).epsilon(1e-6));
  const double order = std::log2((reached(50) - exact) / (reached(100) - exact));
  CHECK(order == Approx(2).margin(0.1));
}

TEST_CASE("the bulk modulus is the slope of the isentrope", "[oracle]") {
  Metal law = shocked(2703, 5350, 1.34, 2.0);
  for (const bool polynomial : {false, true}) {
    if (polynomial) {
      law.eos->model = material::EquationOfState::Model::linear_polynomial;
      law.eos->polynomial = {0, 77e9, 30e9, 90e9, 2.0, 0.5, 0.1};
    }
    const material::PressureLaw eos(*law.eos, law.density);
    for (const double J : {0.75, 0.95, 1.05}) {
      const double e = 2e9, dJ = 1e-6;
      const auto after = [&](double change) {
        return eos
            .close(broadcast(J + change), broadcast(change), pressure_at(eos, broadcast(J), broadcast(e)), broadcast(e),
                   PackMask{})
            .pressure[0];
      };
      const double slope = -J * (after(dJ) - after(-dJ)) / (2 * dJ);
      const Pack pressure = pressure_at(eos, broadcast(J), broadcast(e));
      CHECK(eos.bulk_modulus(broadcast(J), pressure, broadcast(e))[0] == Approx(slope).epsilon(1e-6));
    }
  }
}

TEST_CASE("tension is cut at the minimum pressure; viscous work goes into the energy", "[law]") {
  Metal law = shocked(2703, 5350, 1.34, 2.0);
  law.eos->minimum_pressure = -1e9;
  ShockPoint point{material::MetalResponse<true>(law)};
  for (int k = 0; k < 100; ++k) point.deform(ball(1 + 0.001 * k), ball(1 + 0.001 * (k + 1)), 1e-6);
  CHECK(point.pressure() == Approx(-1e9).epsilon(1e-12));
  ShockPoint heated{material::MetalResponse<true>(law)};
  heated.deform(ball(1), ball(1), 1e-6, 5e7);
  CHECK(heated.scalar(5) == Approx(5e7));
  CHECK(heated.pressure() == Approx(2.0 * 5e7));
}

TEST_CASE("pressure raises the yield stress of the hydrodynamic law", "[oracle]") {
  Metal law = shocked(2703, 5350, 1.34, 0);
  law.shear = 27e9;
  law.strength = material::LinearStrength{100e6, 50e6, 0.02};
  ShockPoint point{material::MetalResponse<true>(law)};
  Matrix before = Matrix::Identity();
  double pressure = 0;
  for (int k = 0; k < 400; ++k) {
    Matrix after = before;
    after(0, 0) -= 2.5e-4;
    pressure = point.pressure();  // the yield stress of a step knows that of its start
    point.deform(before, after, 1e-6);
    before = after;
  }
  const double q = test::equivalent(point.cauchy());
  CHECK(q == Approx(100e6 + 50e6 * point.scalar(0) + 0.02 * pressure).epsilon(1e-10));
}

TEST_CASE("what has failed opens without work and bears pressure only below the volume of the reference", "[law]") {
  const auto check = [](auto point, double bulk) {
    point.scalars[2] = broadcast(1.0);  // damage
    const int energy = std::tuple_size_v<decltype(point.law.fields())> == 6 ? 5 : -1;
    const auto ball = [](double J) { return Matrix(std::cbrt(J) * Matrix::Identity()); };
    const auto go = [&](double from, double to) {
      constexpr int steps = 400;
      for (int k = 0; k < steps; ++k)
        point.deform(ball(from + (to - from) * k / steps), ball(from + (to - from) * (k + 1) / steps), 1e-6);
    };
    for (int cycle = 0; cycle < 3; ++cycle) {
      go(1, 1.25);
      CHECK(point.pressure() == 0);
      if (energy >= 0) CHECK(std::abs(point.scalar(energy)) < 1e-9 * bulk);
      go(1.25, 1);
      CHECK(std::abs(point.pressure()) < 1e-9 * bulk);
    }
    go(1, 0.98);
    CHECK(point.pressure() > 0.02 * bulk);
    CHECK(point.pressure() < 0.022 * bulk);  // a shocked metal stiffens
  };
  Metal law = metals[2];
  law.fracture =
      material::Fracture{0.05, 3.44, -2.12, 0.61, {material::RateFactor::Form::logarithm, 0.002, 1}, 1, false};
  check(Point{material::MetalResponse<false>(law)}, law.bulk);
  Metal hot = shocked(7850, 4569, 1.49, 2.17);
  hot.fracture = law.fracture;
  check(ShockPoint{material::MetalResponse<true>(hot)}, 7850 * 4569.0 * 4569.0);
}
