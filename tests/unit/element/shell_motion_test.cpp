// SPDX-License-Identifier: Apache-2.0
// A free element in central differences, with steps just below its bound.
#include <catch2/catch.hpp>

#include "element/shell4.hpp"
#include "element/shell4_full.hpp"
#include "material/elastic.hpp"
#include "support/shell_bench.hpp"

using namespace brunt;
using material::ElasticResponse;
using test::ShellBench;
using Vector = Eigen::Vector3d;

namespace {

template <int nodes>
using Field = Eigen::Matrix<double, 3, nodes>;

template <class Kernel>
Kernel kernel_of(const element::ShellSection& section) {
  const ElasticResponse law({1, 1, 0.3});
  if constexpr (requires { Kernel{law, section, element::Hourglass{}}; })
    return {law, section, {element::HourglassKind::elastic, 0.05}};
  else
    return {law, section};
}

/// Kinetic energy and momenta of a free element.
template <class Kernel>
struct Flight {
  static constexpr int nodes = Kernel::nodes;
  ShellBench<Kernel> bench;
  Field<nodes> x, v, r;
  typename ShellBench<Kernel>::Answer answer = bench.rest(x);
  double dt = 0.9 / answer.rate;  // a step that follows the rate would feed energy into motions that change it

  void step() {
    v += (dt * nodes / bench.mass) * answer.force;
    r += (dt * nodes / bench.inertia()) * answer.moment;
    x += dt * v;
    answer = bench.move(x, v, r, dt);
  }
  [[nodiscard]] double kinetic() const {
    return 0.5 / nodes * (bench.mass * v.squaredNorm() + bench.inertia() * r.squaredNorm());
  }
  [[nodiscard]] Vector momentum() const { return (bench.mass / nodes) * v.rowwise().sum(); }
  /// v is that of the half step before x, the force that of x.
  [[nodiscard]] Vector angular_momentum() const {
    Vector sum = (bench.inertia() / nodes) * r.rowwise().sum();
    for (int c = 0; c < nodes; ++c) sum += (bench.mass / nodes) * Vector(x.col(c)).cross(Vector(v.col(c)));
    return sum;
  }
};

}  // namespace

TEMPLATE_TEST_CASE("a free element that spins and vibrates keeps its energy and its momenta", "",
                   element::Shell4<ElasticResponse>, element::Shell4Full<ElasticResponse>,
                   element::Shell3<ElasticResponse>) {
  constexpr int nodes = TestType::nodes;
  std::mt19937 engine(8);
  std::uniform_real_distribution<double> any(-1, 1);
  element::ShellSection section;
  section.thickness = 0.1;
  section.points = 3;
  section.thinning = false;
  for (int sample = 0; sample < 4; ++sample) {
    Field<nodes> x, v, r;
    const double corner[4][2] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    const Vector spin = 2e-3 * Vector(any(engine), any(engine), any(engine));
    for (int c = 0; c < nodes; ++c) {
      x.col(c) << corner[c][0] + 0.1 * any(engine), corner[c][1] + 0.1 * any(engine), 0.1 * any(engine);
      v.col(c) = spin.cross(Vector(x.col(c))) + 1e-3 * Vector(any(engine), any(engine), any(engine));
      r.col(c) = spin + 1e-3 * Vector(any(engine), any(engine), any(engine));
    }
    Flight<TestType> flight{{kernel_of<TestType>(section), x, 1}, x, v, r};
    const Vector momentum = flight.momentum(), angular = flight.angular_momentum();
    const auto most_of = [&](int steps) {
      double most = 0;
      for (int step = 0; step < steps; ++step) {
        flight.step();
        most = std::max(most, flight.kinetic());
      }
      return most;
    };
    const double early = most_of(1000);
    most_of(4000);
    CHECK(most_of(1000) == Approx(early).epsilon(0.1));
    CHECK((flight.momentum() - momentum).norm() < 1e-14);
    CHECK((flight.angular_momentum() - angular).norm() < 1e-13);
  }
}
