// SPDX-License-Identifier: Apache-2.0
// Implicit dynamics of free and driven bodies: order of convergence, energy, momentum.
#include <catch2/catch.hpp>
#include <cmath>

#include "implicit/ledger.hpp"
#include "implicit/step.hpp"
#include "mesh/primitives.hpp"
#include "support/simulation.hpp"

using namespace brunt;
using model::Scheme;
using test::Simulation;

namespace {

const std::string rubber = "materials: {m: {model: neo_hookean, density: 1, young: 100, poisson: 0.3}}\n";
const std::string parts = "parts: {b: {material: m, element: hex8_full}}\n";

/// A simulation that goes through time implicitly.
struct ImplicitBody {
  Simulation body;
  implicit::Solver solver;

  ImplicitBody(Simulation simulation, const model::ImplicitSolver& settings)
      : body(std::move(simulation)), solver(implicit::make_solver(scene(), settings)) {}
  implicit::Scene scene() { return {body.model, body.state, body.scratch, body.links}; }
  void steps(int count) {
    const auto place = [](GlobalIndex) { return std::string("node"); };
    for (int n = 0; n < count; ++n) implicit::advance(scene(), solver, place);
  }
  time::Ledger ledger() { return implicit::ledger(scene(), solver); }
};

model::ImplicitSolver settings_of(Scheme scheme, double step, double alpha = 0.1) {
  model::ImplicitSolver settings;
  settings.scheme = scheme;
  settings.step = settings.max_step = step;
  settings.min_step = step / 64;
  settings.alpha = alpha;
  settings.tolerance = 1e-13;
  return settings;
}

/// A bar of two elements that stretches and is thrown with a spin: its first periods are 0.4 and less.
Simulation thrown() {
  Simulation bar(mesh::box("b", {1, 1, 2}, {1, 1, 2}), rubber + parts);
  for (LocalIndex i = 0; i < bar.nodes(); ++i) {
    const Vec3 x = bar.position(i) - Vec3(0.5, 0.5, 1);
    Eigen::Map<Vec3>(bar.state.nodes[static_cast<std::size_t>(i)].v) =
        Vec3(1, 0, 0) + Vec3(0.5, 1, 0.2).cross(x) + Vec3(0, 0, 1.5 * x[2]);
  }
  return bar;
}

std::vector<Vec3> motion_after(Scheme scheme, double end, int steps) {
  ImplicitBody bar(thrown(), settings_of(scheme, end / steps));
  bar.steps(steps);
  std::vector<Vec3> u;
  for (LocalIndex i = 0; i < bar.body.nodes(); ++i) u.push_back(bar.body.displacement(i));
  return u;
}

double distance(const std::vector<Vec3>& a, const std::vector<Vec3>& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += (a[i] - b[i]).squaredNorm();
  return std::sqrt(sum);
}

}  // namespace

TEST_CASE("a free body of rubber: all schemes converge at second order", "[oracle]") {
  constexpr double end = 0.5;
  const std::vector<Vec3> exact = motion_after(Scheme::newmark, end, 3200);
  for (const Scheme scheme : {Scheme::contact_implicit, Scheme::newmark, Scheme::hht}) {
    const double coarse = distance(motion_after(scheme, end, 100), exact);
    const double fine = distance(motion_after(scheme, end, 200), exact);
    CAPTURE(static_cast<int>(scheme), coarse, fine);
    CHECK(std::log2(coarse / fine) == Approx(2).margin(0.05));
  }
}

TEST_CASE("a free body: the ledger closes, momentum stays to rounding", "[law]") {
  for (const Scheme scheme : {Scheme::contact_implicit, Scheme::newmark}) {
    ImplicitBody bar(thrown(), settings_of(scheme, 0.01));
    const time::Ledger start = bar.ledger();
    REQUIRE(start.kinetic > 1);
    double worst = 0, momentum = 0;
    for (int n = 0; n < 100; ++n) {
      bar.steps(1);
      const time::Ledger now = bar.ledger();
      worst = std::max(worst, std::abs(now.total() - start.total()) / start.kinetic);
      momentum = std::max(momentum, (now.momentum - start.momentum).norm() / start.momentum_scale);
    }
    CHECK(worst < 1e-12);
    CHECK(momentum < 1e-12);
    CHECK(bar.ledger().internal > 0.05);
  }
}

TEST_CASE("hht takes energy and gives none", "[law]") {
  ImplicitBody bar(thrown(), settings_of(Scheme::hht, 0.05, 1.0 / 3));
  const double start = bar.ledger().total();
  bar.steps(200);
  CHECK(bar.ledger().total() < start);
  CHECK((bar.ledger().momentum - Vec3(2, 0, 0)).norm() < 1e-11);
}

TEST_CASE("a driven foot: what the drive gives is what the body has, by every kind of drive", "[law]") {
  const std::string given = GENERATE(std::string("velocity"), std::string("displacement"), std::string("acceleration"));
  Simulation bar(mesh::box("b", {1, 1, 2}, {2, 2, 2}),
                 rubber + parts + "curves: {c: [[0, 0], [0.1, 0.2], [0.2, 0.4]]}\nprescribed: [{set: b_zmin, dof: z, " +
                     given + ": c}]\nfixed: [{set: b_zmin, dofs: [x, y]}]\n");
  ImplicitBody body(std::move(bar), settings_of(Scheme::contact_implicit, 0.005));
  body.steps(40);
  const time::Ledger now = body.ledger();
  CHECK(now.external > 1e-4);
  CHECK(std::abs(now.total()) < 1e-11 * now.external);
  // curves c = 2 t: displacement 0.4, velocity's integral 0.04, acceleration's 2/6 t^3 at t = 0.2
  const double foot = given == "displacement" ? 0.4 : given == "velocity" ? 0.04 : 2.0 / 6 * 0.008;
  CHECK(body.body.displacement(body.body.node(0))[2] == Approx(foot).epsilon(1e-12));
  CHECK((now.momentum - now.impulse_given).norm() < 1e-11 * now.momentum_scale);
}

TEST_CASE("a static body under its weight: the sag of a column in one step", "[oracle]") {
  // rho g = 1, E = 100, nu = 0: the top of a column of height 2 sinks by rho g h^2 / (2 E) = 0.02 in linear theory; the
  // strain at the foot, 0.02, changes that by its own order
  Simulation column(mesh::box("b", {1, 1, 2}, {1, 1, 8}),
                    "materials: {m: {model: elastic, density: 1, young: 100, poisson: 0}}\n" + parts +
                        "symmetry: [{point: [0, 0, 0], normal: [1, 0, 0]}, {point: [0, 0, 0], normal: [0, 1, 0]}]\n"
                        "fixed: [{set: b_zmin, dofs: [z]}]\ngravity: {vector: [0, 0, -1]}\n");
  ImplicitBody body(std::move(column), settings_of(Scheme::statics, 1));
  body.steps(1);
  LocalIndex top = 0;
  for (LocalIndex i = 0; i < body.body.nodes(); ++i)
    if (body.body.position(i)[2] > body.body.position(top)[2]) top = i;
  CHECK(body.body.displacement(top)[2] == Approx(-0.02).epsilon(0.02));
  CHECK(body.ledger().kinetic == 0);
  CHECK(std::abs(body.ledger().total()) < 1e-12 * body.ledger().internal);
}
