// SPDX-License-Identifier: Apache-2.0
// One free hexahedron at the program's own step: it has no neighbours to lean on, and the usual h/c is unstable.
#include <catch2/catch.hpp>
#include <cmath>
#include <random>

#include "mesh/primitives.hpp"
#include "support/simulation.hpp"

using namespace brunt;
using test::Simulation;

namespace {

struct FreeCube {
  double poisson;
  double exact_step;  ///< times cp/h: limit of the free cube without hourglass control and bulk viscosity
};

constexpr double edge = 0.01, density = 8000, young = 2e11;

double dilatational_speed(double poisson) {
  return std::sqrt(young * (1 - poisson) / ((1 + poisson) * (1 - 2 * poisson) * density));
}

Simulation free_cube(double poisson, const std::string& options, const std::string& law = "elastic", double speed = 1) {
  Simulation cube(mesh::box("cube", {edge, edge, edge}, {1, 1, 1}),
                  "materials: {m: {model: " + law + ", density: 8000, young: 2.0e11, poisson: " +
                      std::to_string(poisson) + "}}\nparts: {cube: {material: m" + options + "}}\n");
  std::mt19937 engine(3);
  std::uniform_real_distribution<double> noise(-speed, speed);
  for (LocalIndex i = 0; i < 8; ++i)
    Eigen::Map<Vec3>(cube.state.nodes[static_cast<std::size_t>(i)].v) =
        Vec3(noise(engine), noise(engine), noise(engine));
  return cube;
}

/// In so many steps.
double largest_speed(Simulation& cube, int steps) {
  double largest = 0;
  for (int i = 0; i < steps; ++i) {
    cube.step();
    for (LocalIndex node = 0; node < 8; ++node) largest = std::max(largest, cube.velocity(node).norm());
  }
  return largest;
}

}  // namespace

TEST_CASE("a free cube: the program's step is below the exact limit, and 1e5 steps bring no growth", "[oracle]") {
  // limits: exact eigenvalues of the free one-point cube
  for (const FreeCube& known : {FreeCube{0.3, 0.7337993857053424}, FreeCube{0.45, 0.6158817620514397}}) {
    for (const std::string options :
         {"", ", element: hex8_full", ", element: hex8_bbar", ", hourglass: {kind: viscous, coefficient: 0.1}"}) {
      CAPTURE(known.poisson, options);
      Simulation cube = free_cube(known.poisson, options);
      cube.step();
      const double start = cube.ledger().total();
      CHECK(cube.report.dt * dilatational_speed(known.poisson) / edge <= 0.9 * known.exact_step * (1 + 1e-12));
      const double early = largest_speed(cube, 5000);
      cube.steps(options.empty() ? 90000 : 10000);
      const double late = largest_speed(cube, 5000);
      CHECK(late <= 1.1 * early);  // undamped modes beat
      CHECK(late > 0.1 * early);
      CHECK(cube.ledger().total() == Approx(start).epsilon(1e-9));
    }
  }
}

TEST_CASE("a free cube without any damping vibrates for ever at 0.999 of the exact step, and grows at 1.01",
          "[oracle]") {
  for (const FreeCube& known : {FreeCube{0.3, 0.7337993857053424}, FreeCube{0.45, 0.6158817620514397}}) {
    const auto growth = [&](double share) {
      Simulation cube = free_cube(known.poisson, ", hourglass: {kind: none}, bulk: {linear: 0, quadratic: 0}");
      for (model::NodeLine& node : cube.state.nodes)  // pure strain: without control hourglass modes would run away
        for (int c = 0; c < 3; ++c) node.v[c] = 1e-3 * (node.x[c] / edge - 0.5);
      const double dt = share * known.exact_step * edge / dilatational_speed(known.poisson);
      cube.step(dt);
      const double start = cube.velocity(0).norm();
      cube.steps(2000, dt);
      return cube.velocity(0).norm() / start;
    };
    CHECK(growth(0.999) < 1 / std::sqrt(1 - 0.999 * 0.999));
    CHECK_FALSE(growth(1.01) < 1e3);
  }
}

// With nu = 0 all strain modes of a cube share one frequency, at the limit: the step's own bound swings in time with
// them, and a step that followed it would feed them (R. D. Skeel, BIT 33 (1993) 172-175).
TEST_CASE("a free cube with nu = 0 and no viscosity, 1e-3 of the wave speed: 1e5 steps bring no growth", "[law]") {
  struct Known {
    std::string law;
    double growth;  ///< elastic is a rate law: its stress does some work around a closed path of strain
  };
  for (const Known& known : {Known{"neo_hookean", 1.3}, Known{"elastic", 2.5}}) {
    for (const std::string options : {"", ", element: hex8_full", ", element: hex8_bbar"}) {
      CAPTURE(known.law, options);
      Simulation cube =
          free_cube(0, options + ", bulk: {linear: 0, quadratic: 0}", known.law, 1e-3 * dilatational_speed(0));
      cube.step();
      const double start = cube.ledger().total();
      const double early = largest_speed(cube, 5000);
      cube.steps(90000);
      CHECK(largest_speed(cube, 5000) <= known.growth * early);
      CHECK(cube.ledger().total() == Approx(start).epsilon(1e-9));
    }
  }
}

TEST_CASE("a free cube with nu = 0: a step that follows the bound of the moment makes it grow without limit", "[law]") {
  Simulation cube = free_cube(0, ", bulk: {linear: 0, quadratic: 0}", "neo_hookean", 1e-3 * dilatational_speed(0));
  cube.step();
  const double early = largest_speed(cube, 100);
  double late = 0;
  for (int i = 0; i < 4000 && late < 5 * early; ++i) {
    time::StepReport step = time::evaluate(cube.model, cube.state, cube.scratch, cube.links, cube.control);
    step.dt = cube.control.cfl / step.rate;
    step.dt_mean = 0.5 * (cube.state.dt + step.dt);
    time::advance(cube.model, cube.state, cube.scratch, cube.links, nullptr, step);
    for (LocalIndex node = 0; node < 8; ++node) late = std::max(late, cube.velocity(node).norm());
  }
  CHECK(late >= 5 * early);
}
