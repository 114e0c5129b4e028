// SPDX-License-Identifier: Apache-2.0
// Hourglass forces of the one-point quadrilateral of a shell.
#include <catch2/catch.hpp>

#include "element/shell4.hpp"
#include "material/elastic.hpp"
#include "material/j2.hpp"
#include "support/shell_bench.hpp"

using namespace brunt;
using element::HourglassKind;
using material::ElasticResponse;
using test::ShellBench;
using Vector = Eigen::Vector3d;
using Field = Eigen::Matrix<double, 3, 4>;

namespace {

constexpr double thickness = 0.1, coefficient = 0.05;

template <class Response>
ShellBench<element::Shell4<Response>> square(const Response& law, HourglassKind kind, double offset = 0) {
  element::ShellSection section;
  section.thickness = thickness;
  section.points = 3;
  section.offset = offset;
  section.thinning = false;
  Field x;
  x << 0, 1, 1, 0, 0, 0, 1, 1, 0, 0, 0, 0;
  return {{law, section, {kind, coefficient}}, x, 1};
}

Field corners() {
  Field x;
  x << 0, 1, 1, 0, 0, 0, 1, 1, 0, 0, 0, 0;
  return x;
}

/// xi eta at the corners, along `axis`.
Field mode(int axis) {
  Field u = Field::Zero();
  u.row(axis) << 1, -1, 1, -1;
  return u;
}

double energy(const auto& bench) {
  return bench.history.back()[0];
}

}  // namespace

// Springs over A h: k/2 E tr G of the membrane, h^2/12 of that of bending, k/2 5/6 mu G of each shear; G = 4 on each
// axis.
TEST_CASE("hourglass springs of a square shell have the stiffness of the page, and their energy is booked") {
  const double size = 1e-7, E = 1, mu = 1 / 2.6, volume = thickness;
  const double membrane = 0.5 * coefficient * E * 8 * volume, shear = 0.5 * coefficient * 5 / 6 * mu * 4 * volume;
  const ElasticResponse law({1, E, 0.3});
  for (const HourglassKind kind : {HourglassKind::stiffness, HourglassKind::elastic}) {
    const auto push = [&](const Field& v, const Field& r, double stiffness) {
      auto bench = square(law, kind);
      const auto answer = bench.move(corners() + v, v, r);
      const double work = -0.5 * (answer.force.cwiseProduct(v).sum() + answer.moment.cwiseProduct(r).sum());
      CHECK(work == Approx(0.5 * stiffness * size * size).epsilon(1e-6));
      CHECK(energy(bench) == Approx(work).epsilon(1e-6));
    };
    const Field none = Field::Zero();
    push(size * mode(0), none, membrane);
    push(none, size * mode(1), membrane * thickness * thickness / 12);
    push(size * mode(2), none, 2 * shear);  // the deflection is in both
  }
}

TEST_CASE("with an offset the membrane springs see the middle of the shell") {
  auto bench = square(ElasticResponse({1, 1, 0.3}), HourglassKind::elastic, 0.5);
  const double size = 1e-7, z = 0.5 * thickness;
  const Field v = size * mode(0), r = -size / z * mode(1);  // the middle stands still: v + z r x n
  bench.move(corners() + v, v, r);
  const double bending = 0.5 * coefficient * 8 * thickness * thickness * thickness / 12;
  CHECK(energy(bench) == Approx(0.5 * bending * size * size / (z * z)).epsilon(1e-6));
}

TEST_CASE("viscous hourglass forces take the critical damping times the coefficient, and work against the motion") {
  auto bench = square(ElasticResponse({1, 1, 0.3}), HourglassKind::viscous);
  const Field v = 1e-7 * mode(0);
  const double stiffness = 0.5 * 8 * thickness, dashpot = coefficient * std::sqrt(stiffness * bench.mass);
  const auto answer = bench.move(corners() + v, v, Field::Zero());
  CHECK(-answer.force.cwiseProduct(v).sum() == Approx(dashpot * 1e-14).epsilon(1e-6));
  const double before = energy(bench);
  bench.move(corners() + 2 * v, v, Field::Zero());
  CHECK(energy(bench) > before);
  CHECK(bench.rest(corners()).rate > square(ElasticResponse({1, 1, 0.3}), HourglassKind::none).rest(corners()).rate);
}

TEST_CASE("flow takes its share of hourglass forces of kind stiffness only") {
  material::J2 constants;
  constants.density = 1;
  constants.young = 1;
  constants.poisson = 0.3;
  constants.yield = 1e-3;
  const material::J2Response<false, false> law(constants);
  double left[2];
  for (const HourglassKind kind : {HourglassKind::stiffness, HourglassKind::elastic}) {
    auto bench = square(law, kind);
    const Field twist = 1e-5 * mode(0);
    Field x = corners() + twist, stretch = Field::Zero();
    bench.move(x, twist, Field::Zero());
    const int at = element::ShellMemory<material::J2Response<false, false>, 1>(bench.kernel.section).size();
    const double before = bench.history[std::size_t(at)][0];
    stretch.row(0) << 0, 1e-3, 1e-3, 0;
    for (int step = 0; step < 4; ++step) {
      x += stretch;
      bench.move(x, stretch, Field::Zero());
    }
    left[kind == HourglassKind::elastic] = bench.history[std::size_t(at)][0] / before;
  }
  CHECK(left[1] == Approx(1 - 4e-3).epsilon(1e-4));  // stretched by 4e-3, the mode is part of the strain
  CHECK(left[0] < 0.7);
}
