// SPDX-License-Identifier: Apache-2.0
// The matrix of a trial step against differences of its residual, and the solver's parts on a small body.
#include "implicit/data/stiffness.hpp"

#include <catch2/catch.hpp>
#include <random>

#include "implicit/balance.hpp"
#include "implicit/commit.hpp"
#include "implicit/step.hpp"
#include "mesh/primitives.hpp"
#include "support/implicit_system.hpp"
#include "support/simulation.hpp"

using namespace brunt;
using namespace brunt::implicit;
using test::Simulation;

namespace {

/// A block under pressure, held at its foot by an oblique and a straight support.
Simulation pressed(const std::string& law, const std::string& element) {
  return {mesh::box("b", {1, 1.2, 0.8}, {2, 2, 2}),
          "materials: {m: " + law + "}\nparts: {b: {material: m, element: " + element +
              "}}\nfixed: [{set: b_zmin, dofs: [z]}]\nsymmetry: [{point: [0, 0, 0], normal: [1, 0, 0]},\n"
              "  {point: [0, 0, 0], normal: [0, 1, 0]}]\n"
              "pressure: [{set: b_zmax, value: 9.0}, {set: b_ymax, value: 4.0}]\n"};
}

model::ImplicitSolver settings_of(model::Scheme scheme) {
  model::ImplicitSolver settings;
  settings.scheme = scheme;
  settings.step = settings.max_step = 0.01;
  settings.min_step = 1e-5;
  settings.alpha = 0.1;
  return settings;
}

}  // namespace

TEST_CASE("the matrix is the derivative of the residual: every scheme, with pressure and supports") {
  const std::string law =
      GENERATE(std::string("{model: neo_hookean, density: 2, young: 100, poisson: 0.3}"),
               std::string("{model: j2, density: 2, young: 100, poisson: 0.3, yield: 3, hardening: 5}"));
  const auto scheme = GENERATE(model::Scheme::statics, model::Scheme::contact_implicit, model::Scheme::hht);
  Simulation body = pressed(law, "hex8_full");
  const Scene scene{body.model, body.state, body.scratch, body.links};
  Solver solver = make_solver(scene, settings_of(scheme));
  begin_step(scene, solver, 0.01, 0.01);
  std::mt19937 engine(5);
  std::uniform_real_distribution<double> shake(-0.04, 0.04);
  for (double& value : solver.u) value += shake(engine);
  CHECK(test::tangent_error(scene, solver, [](std::size_t) { return 1e-6; }) < 1e-7);
  give_back(scene, solver);
  for (const model::NodeLine& node : body.state.nodes) CHECK(Eigen::Map<const Vec3>(node.v).isZero());
}

TEST_CASE("a static step: uniaxial pressure on one law with a closed form, reactions balance the load") {
  // uniaxial strain (all sides held): s = (lambda + 2 mu) ln-form of neo-Hooke, sigma = mu (J - 1/J) + lambda ln J / J
  Simulation body(mesh::box("b", {1, 1, 1}, {2, 2, 2}),
                  "materials: {m: {model: neo_hookean, density: 2, young: 100, poisson: 0.3}}\n"
                  "parts: {b: {material: m, element: hex8_full}}\n"
                  "symmetry: [{point: [0, 0, 0], normal: [1, 0, 0]}, {point: [1, 0, 0], normal: [1, 0, 0]},\n"
                  "  {point: [0, 0, 0], normal: [0, 1, 0]}, {point: [0, 1, 0], normal: [0, 1, 0]}]\n"
                  "fixed: [{set: b_zmin, dofs: [z]}]\npressure: [{set: b_zmax, value: 40.0}]\n");
  const Scene scene{body.model, body.state, body.scratch, body.links};
  model::ImplicitSolver settings = settings_of(model::Scheme::statics);
  settings.tolerance = 1e-13;
  Solver solver = make_solver(scene, settings);
  advance(scene, solver, [](GlobalIndex) { return std::string("node"); });
  const double mu = 100 / 2.6, lambda = 100 * 0.3 / (1.3 * 0.4);
  const double J = 1 + body.displacement(body.node(26))[2];  // the top corner
  CHECK(mu * (J - 1 / J) + lambda * std::log(J) / J == Approx(-40).epsilon(1e-12));
  double reaction = 0;
  for (LocalIndex i = 0; i < body.nodes(); ++i)
    reaction += body.state.reaction_impulse[3 * static_cast<std::size_t>(i) + 2];
  CHECK(reaction == Approx(0.5 * 40 * 0.01).epsilon(1e-12));  // the mean over a step that begins without load
  CHECK(solver.work.steps == 1);
  CHECK(solver.trial.ratios.back() < 1e-13);
}
