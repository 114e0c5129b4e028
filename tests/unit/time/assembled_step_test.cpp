// SPDX-License-Identifier: Apache-2.0
// The bound of the assembled mesh against exact largest frequencies: never below them, and close.
#include "time/assembled_step.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <random>

#include "mesh/assemble.hpp"
#include "mesh/primitives.hpp"
#include "support/dense_mesh.hpp"
#include "support/simulation.hpp"

using namespace brunt;
using test::Simulation;

namespace {

constexpr const char* materials =
    "materials: {soft: {model: elastic, density: 1, young: 100, poisson: 0.3},\n"
    "            hard: {model: elastic, density: 1, young: 130, poisson: 0.4}}\n";

/// Nodes moved at random by up to `amount` of an edge, edges stretched at random in each direction.
mesh::Mesh random_box(const std::string& part, const std::array<int, 3>& cells, double amount, std::mt19937& engine) {
  std::uniform_real_distribution<double> move(-amount, amount), stretch(0.6, 1.6);
  const Vec3 edge(stretch(engine), stretch(engine), stretch(engine));
  mesh::Mesh box = mesh::box(part, {1.0 * cells[0], 1.0 * cells[1], 1.0 * cells[2]},
                             mesh::Divisions<3>{cells[0], cells[1], cells[2]});
  for (Vec3& x : box.coordinates) x = edge.cwiseProduct(x + Vec3(move(engine), move(engine), move(engine)));
  return box;
}

/// Two bodies beside each other, of unlike elements and materials.
Simulation random_bodies(unsigned seed, const std::string& options) {
  std::mt19937 engine(seed);
  const int n = 2 + static_cast<int>(seed % 3);
  mesh::Mesh mesh = random_box("a", {n, 3, 2}, 0.2, engine);
  mesh::Mesh other = random_box("b", {1, 1, n}, 0.25, engine);
  mesh::place(other, 1, {0, 0, 1}, 0, {100, 0, 0});
  mesh::append(mesh, std::move(other));
  return {std::move(mesh),
          std::string(materials) + "parts: {a: {material: soft" + options + "}, b: {material: hard" + options + "}}\n"};
}

force::LinearElements linear_elements(Simulation& run, double& rate) {
  force::LinearElements linear = force::sized_linear(run.model);
  rate = force::internal_forces(run.model, run.state, run.scratch, {{}, linear}).rate;
  return linear;
}

}  // namespace

TEST_CASE("products: enough for the share and the risk, a few more for a mesh of a million nodes") {
  for (const double unknowns : {24.0, 3e4, 3e6}) {
    const int k = time::lanczos_products(unknowns);
    const auto risk = [&](int products) {
      return 1.648 * std::sqrt(unknowns) * std::exp(-std::sqrt(time::lanczos_share) * (2 * products - 1));
    };
    CHECK(risk(k) <= time::lanczos_risk);
    CHECK(risk(k - 1) > time::lanczos_risk);
  }
  CHECK(time::lanczos_products(3e6) - time::lanczos_products(3e4) <= 4);
}

TEST_CASE("random meshes: the bound is above the exact one of the mesh, by 13 % at most", "[oracle]") {
  // 13 %: 1/sqrt(1 - lanczos_share) is 5.4 %, the rest from strong damping that counts as of another step
  double gain = 0, closest = 2;
  for (const std::string options : {"", ", bulk: {linear: 0.2, quadratic: 0}", ", element: hex8_full",
                                    ", element: hex8_bbar", ", hourglass: {kind: viscous, coefficient: 0.1}"})
    for (unsigned seed = 0; seed < 12; ++seed) {
      CAPTURE(options, seed);
      Simulation run = random_bodies(seed, options);
      double element_rate = 0;
      force::LinearElements linear = linear_elements(run, element_rate);
      const double exact = test::exact_rate(run, linear, element_rate);
      const double bound = time::assembled_rate(run.model, run.state, run.links, linear, element_rate);
      // the elements' bound takes dashpots on hourglass modes for themselves, and is not quite one where these strain
      // too
      const bool dashpots = options.find("viscous") != std::string::npos;
      CHECK(exact <= element_rate * (dashpots ? 1.03 : 1 + 1e-9));
      CHECK(bound >= std::min(exact, element_rate));
      CHECK(bound <= std::min(1.13 * exact, element_rate));
      gain = std::max(gain, element_rate / bound);
      if (!dashpots) closest = std::min(closest, bound / exact);
    }
  CHECK(gain >= 1.15);
  CHECK(closest >= 1);
}

TEST_CASE("what has stiffened since the estimate bounds the mesh that has been deformed at random", "[oracle]") {
  for (unsigned seed = 0; seed < 12; ++seed)
    for (const double size : {0.02, 0.08, 0.16}) {
      CAPTURE(seed, size);
      Simulation run = random_bodies(seed, "");
      run.bound_by_mesh();
      run.report = time::evaluate(run.model, run.state, run.scratch, run.links, run.control);
      CHECK(run.assembled.rate > 0);
      // of any homogeneous deformation, and a random motion of single nodes
      std::mt19937 engine(1000 + seed);
      std::uniform_real_distribution<double> any(-size, size);
      Mat3 F;
      for (int i = 0; i < 9; ++i) F(i / 3, i % 3) = any(engine);
      std::vector<Vec3> u;
      for (LocalIndex i = 0; i < run.nodes(); ++i) {
        const Vec3 x = run.position(run.node(i)), alone(any(engine), any(engine), any(engine));
        u.push_back(F * x + 0.3 * alone);
      }
      run.state.step = 1;
      run.displace(u, 1e4);
      double element_rate = 0;
      run.state.dt = 0;
      const force::LinearElements linear = linear_elements(run, element_rate);
      const double exact = test::exact_rate(run, linear, element_rate);
      CHECK(run.report.bound >= exact);
      CHECK(run.report.bound <= run.report.rate);
    }
}

TEST_CASE("estimates: the first at once, the same when asked again; others where they may give more and are paid for") {
  Simulation run(mesh::box("a", {4, 4, 4}, {4, 4, 4}),
                 std::string(materials) + "parts: {a: {material: soft}}\nremove: [{part: a, at: 0.05}]\n");
  run.bound_by_mesh();
  CHECK(time::estimate_is_due(run.assembled, run.state));
  const auto evaluate = [&] { return time::evaluate(run.model, run.state, run.scratch, run.links, run.control); };
  const time::StepReport first = evaluate(), again = evaluate();
  CHECK(first.bound == again.bound);
  CHECK(first.bound < 0.8 * first.rate);
  CHECK(run.assembled.estimates == 1);
  const auto due_at = [&](int step) {
    run.state.step = step;
    return time::estimate_is_due(run.assembled, run.state);
  };
  CHECK_FALSE(due_at(0));
  CHECK_FALSE(due_at(10 * time::estimate_span));  // nothing has changed
  time::outdate(run.assembled);
  CHECK_FALSE(due_at(time::estimate_span - 1));
  CHECK(due_at(time::estimate_span));
  run.assembled.step = time::estimate_span - 1;
  CHECK_FALSE(due_at(time::estimate_span));
  CHECK(due_at(time::estimate_span - 1 + time::estimate_pause));
  run.state.step = 1;
  run.assembled.rate = 0;
  CHECK(evaluate().bound == first.rate);
}

TEST_CASE("an estimate is outdated where elements have stiffened or softened by more than matters") {
  Simulation run(mesh::box("a", {4, 4, 4}, {4, 4, 4}), std::string(materials) + "parts: {a: {material: soft}}\n");
  time::AssembledStep assembled{
      .rate = 0.7, .element_rate = 1, .step = 0, .estimates = 1, .outdated = 0, .baseline = {}};
  run.state.step = 5;
  const auto outdated = [&](double growth, double element_rate) {
    assembled.outdated = 0;
    const double bound = time::bounding_rate(assembled, run.state, growth, element_rate);
    CHECK(bound <= element_rate);
    CHECK(bound >= std::min(element_rate, assembled.rate));
    return assembled.outdated > 0;
  };
  const double much = 1 + time::worth_an_estimate;
  CHECK_FALSE(outdated(0.9, 1));
  CHECK_FALSE(outdated(0.999 * much * much, 1));
  CHECK(outdated(1.001 * much * much, 1));
  CHECK_FALSE(outdated(1, 1.001 / much));
  CHECK(outdated(1, 0.999 / much));
  assembled.rate = 0;  // none was made since the elements allowed all that was asked for
  CHECK_FALSE(outdated(1, 0.999 * much));
  CHECK(outdated(1, 1.001 * much));
}

TEST_CASE("no estimate where the longest step asked for is below that of the elements") {
  Simulation run(mesh::box("a", {4, 4, 4}, {4, 4, 4}), std::string(materials) + "parts: {a: {material: soft}}\n");
  run.bound_by_mesh();
  run.control.largest = 1e-3;
  run.step();
  CHECK(run.assembled.estimates == 0);
  CHECK(run.report.bound == run.report.rate);
  CHECK(run.report.dt == 1e-3);
}

TEST_CASE("a free element has its own bound", "[oracle]") {
  Simulation cube(mesh::box("a", {1, 1, 1}, {1, 1, 1}), std::string(materials) + "parts: {a: {material: soft}}\n");
  cube.bound_by_mesh();
  cube.step();
  CHECK(cube.report.bound == cube.report.rate);
}

TEST_CASE("a mesh without damping vibrates for ever at the whole stable step of the mesh, and grows at 1.15 of it",
          "[oracle]") {
  const auto growth = [](double cfl, int steps) {
    Simulation run(mesh::box("a", {4, 4, 4}, {4, 4, 4}),
                   std::string(materials) + "parts: {a: {material: soft, bulk: {linear: 0, quadratic: 0}}}\n");
    run.bound_by_mesh();
    run.control.cfl = cfl;
    std::mt19937 engine(7);
    std::uniform_real_distribution<double> noise(-1e-6, 1e-6);
    for (model::NodeLine& node : run.state.nodes)
      for (double& v : node.v) v = noise(engine);
    run.steps(steps);
    double speed = 0;
    for (LocalIndex i = 0; i < run.nodes(); ++i)
      if (const double v = run.velocity(i).norm(); !(v <= speed)) speed = v;
    if (cfl == 1) CHECK(run.report.bound < 0.8 * run.report.rate);
    return speed / 1e-6;
  };
  // at a share s of the limit a frequency swings 1/sqrt(1 - s^2) times as far: 3.2 times 1.73 at s = 0.95
  CHECK(growth(1.0, 6000) <= 6);
  CHECK_FALSE(growth(1.15, 600) < 1e3);
}
