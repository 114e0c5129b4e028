// SPDX-License-Identifier: Apache-2.0
// Contact of a part with itself as part of the system: its matrix against differences, what can meet and what cannot.
#include "implicit/mortar/self_contact.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <random>

#include "contact/mortar/corners.hpp"
#include "implicit/balance.hpp"
#include "implicit/commit.hpp"
#include "mesh/assemble.hpp"
#include "mesh/primitives.hpp"
#include "support/implicit_system.hpp"
#include "support/simulation.hpp"

using namespace brunt;
using namespace brunt::implicit;
using test::Simulation;

namespace {

/// A further box of the same part.
void add_box(mesh::Mesh& mesh, const Vec3& size, const std::array<int, 3>& elements, const Vec3& at) {
  mesh::Mesh above = mesh::box("other", size, {elements[0], elements[1], elements[2]});
  for (Vec3& x : above.coordinates) x += at;
  mesh::append(mesh, std::move(above));
  mesh::Block &first = mesh.blocks.front(), &last = mesh.blocks.back();
  first.nodes.insert(first.nodes.end(), last.nodes.begin(), last.nodes.end());
  first.element_id.insert(first.element_id.end(), last.element_id.begin(), last.element_id.end());
  mesh.blocks.pop_back();
  mesh.node_sets.clear();
  mesh.side_sets.clear();
}

Simulation simulation(mesh::Mesh mesh, const std::string& contact) {
  return {std::move(mesh),
          "materials: {m: {model: neo_hookean, density: 2, young: 100, poisson: 0.3}}\n"
          "parts: {low: {material: m, element: hex8_full}}\nsets: {foot: {part: low, box: [[-9, -9, 0], [9, 9, 0]]}}\n"
          "fixed: [{set: foot, dofs: [x, y, z]}]\ncontact: [{between: [low, low], method: mortar" +
              contact + "}]\n"};
}

model::ImplicitSolver statics() {
  model::ImplicitSolver settings;
  settings.scheme = model::Scheme::statics;
  settings.step = settings.max_step = 0.01;
  settings.min_step = 1e-5;
  return settings;
}

/// Of a slave facet and a master facet: the normals' product.
double product_of_normals(const Interface& face, std::span<const Vec3> x, LocalIndex slave, LocalIndex master) {
  const auto normal = [&](const contact::FacetNodes& facet) {
    const contact::CornersOf corners(facet, x);
    return Vec3((corners.x[2] - corners.x[0]).cross(corners.x[3] - corners.x[1]).normalized());
  };
  return normal(face.surfaces.slave[static_cast<std::size_t>(slave)])
      .dot(normal(face.surfaces.master[static_cast<std::size_t>(master)]));
}

}  // namespace

TEST_CASE("the matrix of a part in contact with itself is the derivative of the residual") {
  const std::string contact = GENERATE(std::string(""), std::string(", multiplier: standard"),
                                       std::string(", enforce: penalty"), std::string(", friction: 0.05"));
  CAPTURE(contact);
  mesh::Mesh mesh = mesh::box("low", {1, 1, 0.5}, {2, 2, 1});
  const GlobalIndex in_low = 18;
  add_box(mesh, {0.9, 1.1, 0.5}, {3, 3, 1}, {0.02, -0.03, 0.5});
  Simulation body = simulation(std::move(mesh), contact);
  const Scene scene{body.model, body.state, body.scratch, body.links};
  Solver solver = make_solver(scene, statics());
  REQUIRE(solver.contact.interfaces.front().self);
  begin_step(scene, solver, 0.01, 0.01);
  std::mt19937 engine(7);
  std::uniform_real_distribution<double> shake(-0.01, 0.01);
  const std::size_t nodes = solver.unknowns.node.size();
  for (std::size_t k = 0; k < nodes; ++k)
    for (std::size_t c = 0; c < 3; ++c) solver.u[3 * k + c] += shake(engine);
  for (GlobalIndex n = in_low; n < body.nodes(); ++n) {  // the upper box is pressed in, and drawn along
    const auto at = std::ranges::lower_bound(solver.unknowns.node, body.node(n)) - solver.unknowns.node.begin();
    solver.u[3 * static_cast<std::size_t>(at)] += 0.01;
    solver.u[3 * static_cast<std::size_t>(at) + 2] -= 0.02;
  }
  for (std::size_t k = 3 * nodes; k < solver.u.size(); ++k) solver.u[k] = 20 + 100 * shake(engine);
  const auto step_of = [&](std::size_t unknown) { return unknown < 3 * nodes ? 1e-6 : 1e-3; };  // a pressure is large
  CHECK(test::tangent_error(scene, solver, step_of) < 1e-7);
  (void)test::residual_at(scene, solver, solver.u);
  CHECK(count(solver.contact).active > 5);
  Vec3 sum = Vec3::Zero();
  double size = 0;
  for (const Vec3& force : solver.contact.nodes.force) {
    sum += force;
    size += force.norm();
  }
  CHECK(size > 1);
  CHECK(sum.norm() < 1e-13 * size);
}

TEST_CASE("the sides of a wall never meet, nor do neighbours: the far side of a tube does") {
  Simulation body = simulation(mesh::tube("low", 2, 2.5, 1, {1, 24, 2}), "");
  const Scene scene{body.model, body.state, body.scratch, body.links};
  const Solver solver = make_solver(scene, statics());
  const Interface& face = solver.contact.interfaces.front();
  REQUIRE(face.self);
  const std::span<const Vec3> x = solver.contact.nodes.x;
  CHECK(face.surfaces.capture == Approx(0.25).epsilon(0.02));  // half of the wall, between the middles of chords
  const auto radius = [&](const contact::FacetNodes& facet) {
    double most = 0;
    for (const LocalIndex node : facet) most = std::max(most, x[static_cast<std::size_t>(node)].head<2>().norm());
    return most;
  };
  int walls = 0, across = 0;
  for (LocalIndex s = 0; s < static_cast<LocalIndex>(face.surfaces.slave.size()); ++s)
    for (LocalIndex m = 0; m < static_cast<LocalIndex>(face.surfaces.master.size()); ++m) {
      const contact::FacetNodes &one = face.surfaces.slave[static_cast<std::size_t>(s)],
                                &other = face.surfaces.master[static_cast<std::size_t>(m)];
      const bool never =
          std::ranges::binary_search(face.self->never.row(s), face.self->master[static_cast<std::size_t>(m)]);
      const bool neighbours =
          std::ranges::any_of(one, [&](LocalIndex node) { return std::ranges::find(other, node) != other.end(); });
      if (neighbours) CHECK(never);
      if (product_of_normals(face, x, s, m) > -0.99 || neighbours) continue;
      const double between = (x[static_cast<std::size_t>(one[0])] - x[static_cast<std::size_t>(other[0])]).norm();
      if (std::min(radius(one), radius(other)) < 2.1 && std::max(radius(one), radius(other)) > 2.4 && between < 1.2) {
        ++walls;
        CHECK(never);
      } else if (between > 3) {
        ++across;
        CHECK_FALSE(never);
        CHECK(face.self->admits(s, m) != face.self->admits(m, s));
      }
    }
  CHECK(walls >= 2 * 24 * 2);
  CHECK(across >= 24 * 2);
}

TEST_CASE("boxes of one part that touch at the start are no wall") {
  mesh::Mesh mesh = mesh::box("low", {1, 1, 0.5}, {2, 2, 1});
  add_box(mesh, {1, 1, 0.5}, {2, 2, 1}, {0.25, 0.25, 0.5 - 1e-5});
  Simulation body = simulation(std::move(mesh), "");
  const Scene scene{body.model, body.state, body.scratch, body.links};
  const Solver solver = make_solver(scene, statics());
  const Interface& face = solver.contact.interfaces.front();
  CHECK(face.surfaces.capture == Approx(0.25));
  CHECK(count(solver.contact).segments > 3);
}
