// SPDX-License-Identifier: Apache-2.0
// Rigid bodies as part of the system: its matrix against differences, motions with closed forms, energy.
#include "implicit/rigid_bodies.hpp"

#include <catch2/catch.hpp>
#include <random>

#include "implicit/balance.hpp"
#include "implicit/commit.hpp"
#include "implicit/ledger.hpp"
#include "implicit/step.hpp"
#include "mesh/assemble.hpp"
#include "mesh/primitives.hpp"
#include "support/implicit_system.hpp"
#include "support/simulation.hpp"

using namespace brunt;
using namespace brunt::implicit;
using test::Simulation;

namespace {

/// A bar whose elements beyond the middle are a block of their own, with the nodes between in common; top: its upper
/// faces.
mesh::Mesh joined() {
  mesh::Mesh mesh = mesh::box("bar", {2, 1, 0.8}, {4, 2, 1});
  mesh::Block& bar = mesh.blocks.front();
  mesh::Block head = bar, rest = bar;
  for (mesh::Block* block : {&head, &rest}) {
    block->nodes.clear();
    block->element_id.clear();
  }
  std::vector<mesh::Side> above = mesh.side_sets.at("bar_zmax"), top;
  head.name = "head";
  head.id = 2;
  for (LocalIndex e = 0; e < bar.count(); ++e) {
    double x = 0;
    for (int c = 0; c < 8; ++c) x += mesh.coordinates[static_cast<std::size_t>(bar.element(e)[c])][0] / 8;
    mesh::Block& to = x > 1 ? head : rest;
    to.nodes.insert(to.nodes.end(), bar.element(e), bar.element(e) + 8);
    to.element_id.push_back(bar.element_id[static_cast<std::size_t>(e)]);
    for (const mesh::Side& side : above)
      if (side.element == e && &to == &head) top.push_back({1, to.count() - 1, side.face});
  }
  mesh.blocks = {rest, head};
  mesh.side_sets.clear();
  mesh.node_sets.clear();
  mesh.side_sets["top"] = top;
  return mesh;
}

constexpr const char* materials =
    "materials: {m: {model: neo_hookean, density: 2, young: 100, poisson: 0.3}, hard: {model: rigid, density: 3}}\n";

/// With a block under the head that contact or a tie joins to it; supports of the head, and the rest.
Simulation pressed(const std::string& fixed, const std::string& more) {
  mesh::Mesh mesh = joined(), below = mesh::box("low", {1.1, 1.2, 0.5}, {2, 3, 1});
  for (Vec3& x : below.coordinates) x += Vec3(1.03, -0.08, -0.5);
  mesh::append(mesh, std::move(below));
  return {std::move(mesh), materials +
                               std::string("parts: {bar: {material: m, element: hex8_full}, head: {material: hard}, "
                                           "low: {material: m, element: hex8_full}}\n"
                                           "sets: {foot: {part: low, box: [[1, -1, -0.5], [3, 2, -0.5]]}, end: {part: "
                                           "bar, box: [[0, 0, 0], [0, 1, 1]]}}\n"
                                           "gravity: {vector: [0, 1, -2]}\npressure: [{set: top, value: 4.0}]\n"
                                           "curves: {go: [[0, 0], [1, 2]]}\n"
                                           "fixed: [{set: foot, dofs: [x, y, z]}, {set: end, dofs: [x, y, z]}") +
                               fixed + "]\n" + more};
}

model::ImplicitSolver settings_of(model::Scheme scheme, double step = 0.01) {
  model::ImplicitSolver settings;
  settings.scheme = scheme;
  settings.step = settings.max_step = step;
  settings.min_step = step / 1024;
  return settings;
}

/// The largest entry of what the matrix says of each unknown that is not a body's node, these following the bodies, off
/// from central differences; over its largest entry.
double tangent_error(const Scene& scene, Solver& solver) {
  (void)test::residual_at(scene, solver, solver.u);
  REQUIRE(factorise_tangent(scene, solver).ok());
  const Eigen::MatrixXd K = test::dense(solver.rows);
  const std::size_t nodes = solver.unknowns.node.size(), first = solver.bodies.first_here;
  double worst = 0;
  for (std::size_t c = 0; c < solver.u.size(); ++c) {
    if (c < 3 * nodes && solver.bodies.carries(c / 3)) continue;
    const auto column = static_cast<Eigen::Index>(c);
    Eigen::VectorXd says = K.col(column);
    for (std::size_t k = 0; c >= first && k < 3 * nodes; ++k) {
      const auto row = static_cast<Eigen::Index>(k);
      if (solver.bodies.carries(k / 3)) says -= K.col(row) * (K(row, column) / K(row, row));
    }
    const double h = c < 3 * nodes || c >= first ? 1e-6 : 1e-3;  // a pressure is large
    std::vector<double> ahead = solver.u, behind = solver.u;
    ahead[c] += h;
    behind[c] -= h;
    const Eigen::VectorXd slope =
        (test::residual_at(scene, solver, ahead) - test::residual_at(scene, solver, behind)) / (2 * h);
    worst = std::max(worst, (slope - says).lpNorm<Eigen::Infinity>());
  }
  return worst / K.lpNorm<Eigen::Infinity>();
}

std::string nobody(GlobalIndex /*gid*/) {
  return "node";
}

Simulation lonely(const std::string& more) {
  return {mesh::box("tool", {0.6, 0.4, 0.2}, {2, 2, 1}),
          materials + std::string("parts: {tool: {material: hard}}\nsolver: {step: 0.01}\n") + more};
}

}  // namespace

TEST_CASE("the matrix with rigid bodies is the derivative of the residual: schemes, supports, contact, ties") {
  const auto scheme = GENERATE(model::Scheme::statics, model::Scheme::contact_implicit);
  const std::string more = GENERATE(
      std::string("initial: [{part: head, velocity: [0.1, 0.2, -1], rotation: {axis: [1, 2, 0.5], rate: 3}}]\n"),
      std::string(),
      std::string("prescribed: [{part: head, dof: rz, velocity: go}, {part: head, dof: y, velocity: go}]\n"),
      std::string(
          "rigid_walls: [{point: [0, 0, 0], normal: [0, 0, 1], friction: 0.2, parts: [head]}, {point: [2.01, 0, "
          "0], normal: [-1, 0, 0.2], parts: [head]}]\n"),
      std::string("contact: [{between: [low, head], method: mortar}]\n"),
      std::string("contact: [{between: [low, head], method: mortar, friction: 0.1}]\n"),
      std::string("contact: [{between: [head, low], method: mortar, tied: true}]\n"));
  CAPTURE(static_cast<int>(scheme), more);
  Simulation body = pressed(more.empty() ? ", {part: head, dofs: [x, ry, rx]}" : "", more);
  const Scene scene{body.model, body.state, body.scratch, body.links};
  Solver solver = make_solver(scene, settings_of(scheme));
  REQUIRE(solver.bodies.any());
  begin_step(scene, solver, 0.01, 0.01);
  std::mt19937 engine(5);
  std::uniform_real_distribution<double> shake(-0.01, 0.01);
  const std::size_t nodes = solver.unknowns.node.size(), first = solver.bodies.first_here;
  for (std::size_t k = 0; k < solver.u.size(); ++k)
    solver.u[k] += k < 3 * nodes || k >= first ? shake(engine) : 20 + 100 * shake(engine);
  for (int c : {3, 4, 5}) solver.u[first + static_cast<std::size_t>(c)] += 0.02 * c;
  solver.u[first + 2] -= 0.03;
  if (solver.walls.any()) {  // behind the first iterate, at which friction sticks
    (void)test::residual_at(scene, solver, solver.u);
    REQUIRE(factorise_tangent(scene, solver).ok());
  }
  CHECK(tangent_error(scene, solver) < 1e-7);
  // a rotation that goes on from where the matrix was laid
  for (std::size_t k = first; k < solver.u.size(); ++k) solver.u[k] += 0.5 * shake(engine);
  CHECK(tangent_error(scene, solver) < 1e-7);
  give_back(scene, solver);
}

TEST_CASE("a rigid block falls: exact at any step, with a spin that goes on about an axis of symmetry") {
  Simulation body = lonely(
      "gravity: {vector: [0, 0, -10]}\n"
      "initial: [{part: tool, velocity: [1, 0, 2], rotation: {axis: [0, 0, 1], rate: 4, point: [0.3, 0.2, 0]}}]\n");
  const Scene scene{body.model, body.state, body.scratch, body.links};
  Solver solver = make_solver(scene, settings_of(model::Scheme::contact_implicit, 0.05));
  for (int i = 0; i < 10; ++i) advance(scene, solver, nobody);
  const rigid::BodyState& state = body.state.bodies[0];
  CHECK((state.displacement - Vec3(0.5, 0, 2 * 0.5 - 5 * 0.25)).norm() < 1e-13);
  CHECK((state.velocity - Vec3(1, 0, 2 - 5)).norm() < 1e-13);
  CHECK(rigid::angular_velocity(body.model.bodies[0].body, state)[2] == Approx(4).epsilon(1e-12));
  const time::Ledger end = ledger(scene, solver);
  CHECK(end.external == Approx(body.model.bodies[0].body.mass.mass * 10 * 0.25).epsilon(1e-12));
  for (LocalIndex i = 0; i < body.nodes(); ++i) {  // nodes are where the body is, and as fast
    const auto k = static_cast<std::size_t>(i);
    const Vec3 arm = state.orientation * body.model.bodies[0].arm[k];
    CHECK((body.position(i) - body.model.bodies[0].body.mass.centre - state.displacement - arm).norm() < 1e-14);
    CHECK((body.velocity(i) - state.velocity - Vec3(0, 0, 4).cross(arm)).norm() < 1e-12);
  }
}

TEST_CASE("a torque-free spin keeps angular momentum and energy, and is of second order") {
  const auto turned_after = [](double step, int steps) {
    Simulation body = lonely(
        "initial: [{part: tool, velocity: [0, 0, 0], rotation: {axis: [1, 8, 1], rate: 10, point: "
        "[0.3, 0.2, 0.1]}}]\n");
    const Scene scene{body.model, body.state, body.scratch, body.links};
    model::ImplicitSolver settings = settings_of(model::Scheme::contact_implicit, step);
    settings.tolerance = 1e-13;
    Solver solver = make_solver(scene, settings);
    const Vec3 momentum = body.state.bodies[0].angular_momentum;
    const double energy = ledger(scene, solver).kinetic;
    for (int i = 0; i < steps; ++i) advance(scene, solver, nobody);
    CHECK((body.state.bodies[0].angular_momentum - momentum).norm() < 1e-10 * momentum.norm());
    CHECK(ledger(scene, solver).kinetic == Approx(energy).epsilon(1e-10));
    return body.state.bodies[0].orientation;
  };
  const Eigen::Quaterniond coarse = turned_after(0.01, 32), middle = turned_after(0.005, 64),
                           fine = turned_after(0.0025, 128);
  const double order = std::log2(coarse.angularDistance(middle) / middle.angularDistance(fine));
  CHECK(order > 1.9);
  CHECK(order < 2.1);
}

TEST_CASE("supports of bodies: a driven angle and a driven path are met, and their work is in the ledger") {
  Simulation body = lonely(
      "curves: {go: [[0, 0], [1, 2]]}\ngravity: {vector: [0, 0, -10]}\nfixed: [{part: tool, dofs: [x, y, rx, ry]}]\n"
      "prescribed: [{part: tool, dof: rz, displacement: go}, {part: tool, dof: z, velocity: go}]\n");
  const Scene scene{body.model, body.state, body.scratch, body.links};
  Solver solver = make_solver(scene, settings_of(model::Scheme::contact_implicit, 0.05));
  const double start = ledger(scene, solver).total();
  for (int i = 0; i < 20; ++i) advance(scene, solver, nobody);
  const rigid::BodyState& state = body.state.bodies[0];
  const rigid::MassProperties& mass = body.model.bodies[0].body.mass;
  CHECK((state.displacement - Vec3(0, 0, 1)).norm() < 1e-12);
  CHECK(2 * std::atan2(state.orientation.z(), state.orientation.w()) == Approx(2).epsilon(1e-12));
  CHECK(state.velocity[2] == Approx(2).epsilon(1e-12));
  const time::Ledger end = ledger(scene, solver);
  CHECK(end.total() == Approx(start).margin(1e-12 * mass.mass));
  CHECK(end.kinetic == Approx(0.5 * mass.mass * 4 + 0.5 * mass.inertia(2, 2) * 4).epsilon(1e-12));
  CHECK(body.state.body_accounts[0].reaction_impulse[2] == Approx(mass.mass * (2 + 10)).epsilon(1e-12));
}

TEST_CASE("a body joined to a bar that deforms: energy and momentum of the whole are kept") {
  mesh::Mesh mesh = joined();
  Simulation body(std::move(mesh), materials + std::string("parts: {bar: {material: m, element: hex8_full}, head: "
                                                           "{material: hard}}\n"
                                                           "initial: [{part: head, velocity: [0, 0.3, -0.5], rotation: "
                                                           "{axis: [1, 2, 0.5], rate: 0.5}}]\n"));
  const Scene scene{body.model, body.state, body.scratch, body.links};
  Solver solver = make_solver(scene, settings_of(model::Scheme::contact_implicit, 0.02));
  const time::Ledger start = ledger(scene, solver);
  for (int i = 0; i < 20; ++i) advance(scene, solver, nobody);
  const time::Ledger end = ledger(scene, solver);
  CHECK(end.internal > 1e-3 * start.kinetic);
  CHECK(end.total() == Approx(start.total()).epsilon(1e-9));  // what Newton's iteration leaves of 1e-10 a step
  CHECK((end.momentum - start.momentum).norm() < 1e-9 * start.momentum.norm());
}
