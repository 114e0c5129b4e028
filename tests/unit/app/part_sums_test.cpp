// SPDX-License-Identifier: Apache-2.0
// Energies and momenta of parts, also where parts share nodes, and what they sum up to.
#include "app/report/part_sums.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <catch2/catch.hpp>
#include <cmath>

#include "app/report/probes.hpp"
#include "prepared_scene.hpp"
#include "time/ledger.hpp"

using namespace brunt;

namespace {

const std::string probes =
    "probes:\n"
    "  - {name: a, part: low, field: energy}\n"
    "  - {name: b, part: top, field: energy}\n"
    "  - {name: c, part: low, field: momentum}\n"
    "  - {name: d, part: top, field: momentum}\n"
    "  - {name: e, part: low, field: mass}\n"
    "  - {name: f, part: top, field: mass}\n";

/// Gmsh 2.2: blocks low and top, two cubes of 2^3 elements that share the nodes between them.
std::string joined_cubes() {
  std::string nodes, elements;
  int count = 0, id = 0;
  for (int k = 0; k <= 4; ++k)
    for (int j = 0; j <= 2; ++j)
      for (int i = 0; i <= 2; ++i)
        nodes +=
            std::to_string(++id) + " " + std::to_string(i) + " " + std::to_string(j) + " " + std::to_string(k) + "\n";
  const auto node = [](int i, int j, int k) { return std::to_string(1 + i + 3 * j + 9 * k) + " "; };
  for (int k = 0; k < 4; ++k)
    for (int j = 0; j < 2; ++j)
      for (int i = 0; i < 2; ++i) {
        const std::string tag = k < 2 ? "1 1 " : "2 2 ";
        elements += std::to_string(++count) + " 5 2 " + tag + node(i, j, k) + node(i + 1, j, k) +
                    node(i + 1, j + 1, k) + node(i, j + 1, k) + node(i, j, k + 1) + node(i + 1, j, k + 1) +
                    node(i + 1, j + 1, k + 1) + node(i, j + 1, k + 1) + "\n";
      }
  return "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n2\n3 1 \"low\"\n3 2 "
         "\"top\"\n$EndPhysicalNames\n$Nodes\n" +
         std::to_string(id) + "\n" + nodes + "$EndNodes\n$Elements\n" + std::to_string(count) + "\n" + elements +
         "$EndElements\n";
}

void check_sums(support::PreparedScene& scene, int steps) {
  app::Probes watched(*scene.run, *scene::find_unit_system("SI"));
  for (int i = 0; i < steps; ++i) {
    scene.evaluate();
    watched.read_motion(*scene.run);
    scene.advance();
  }
  const app::Prepared& run = *scene.run;
  const time::Ledger ledger =
      time::ledger(run.model, run.state, run.scratch, run.links, run.contact.get(), scene.report);
  const std::vector<double> row = watched.values(*scene.run, ledger.contact_totals, scene.report.dt_mean);
  const double scale = ledger.kinetic + std::abs(ledger.internal);
  CHECK(std::abs(ledger.internal) > 1e-6 * scale);
  CHECK(std::abs(row[0] + row[4] - ledger.kinetic) < 1e-13 * scale);
  CHECK(std::abs(row[1] + row[5] - ledger.internal) < 1e-13 * scale);
  CHECK(std::abs(row[2] + row[6] - ledger.hourglass) < 1e-13 * scale);
  CHECK(std::abs(row[3] + row[7] - ledger.bulk) < 1e-13 * scale);
  for (std::size_t c = 0; c < 3; ++c)
    CHECK(std::abs(row[8 + c] + row[11 + c] - ledger.momentum[static_cast<int>(c)]) < 1e-13 * ledger.momentum_scale);
  CHECK(row[14] + row[15] == Approx(ledger.mass).epsilon(1e-14));
  CHECK(row[1] != 0);
  CHECK(row[5] != 0);
}

}  // namespace

TEST_CASE("parts: energies, momenta and masses sum up to those of the model") {
  support::PreparedScene scene(support::two_bodies + "contact: [{between: all}]\n" + probes);
  check_sums(scene, 60);
}

TEST_CASE("parts: also where they share nodes, whose work is booked element by element") {
  const std::string scene =
      "units: SI\nmesh: {file: joined.msh}\n"
      "materials: {m: {model: elastic, density: 3, young: 1.0e4, poisson: 0.3}}\n"
      "parts: {low: {material: m}, top: {material: m, element: hex8_full}}\n"
      "initial: [{part: top, velocity: [1, 0, -2]}]\nrun: {end: 1}\n";
  support::PreparedScene joined(scene + probes, "joined.msh", joined_cubes());
  CHECK(joined.run->model.between_parts.booked);
  check_sums(joined, 40);
  support::PreparedScene without(scene, "joined.msh", joined_cubes());
  CHECK_FALSE(without.run->model.between_parts.booked);
  CHECK(without.run->state.interface_work.empty());
}

TEST_CASE("parts: a spinning ring has the angular momentum of its points, whatever it is taken about") {
  const double rate = 5;
  const Vec3 axis = GENERATE(Vec3(0, 0, 1), Vec3(1, 2, -1));
  const std::string turn = fmt::format("[{}, {}, {}]", axis[0], axis[1], axis[2]);
  support::PreparedScene scene(
      "units: SI\nmesh: {tube: {part: ring, inner_radius: 0.8, outer_radius: 1, length: 0.2, elements: [1, 12, 1]}}\n"
      "materials: {m: {model: elastic, density: 3, young: 1.0e4, poisson: 0}}\nparts: {ring: {material: m}}\n"
      "initial: [{part: ring, velocity: [1, 2, 3], rotation: {axis: " +
      turn +
      ", rate: 5}}]\nrun: {end: 1}\n"
      "probes: [{name: p, part: ring, field: angular_momentum}, {name: q, part: ring, field: angular_momentum, about: "
      "[4, 5, 6]},\n"
      "  {name: c, part: ring, field: center}, {name: m, part: ring, field: momentum}, {name: mass, part: ring, field: "
      "mass}]\n");
  app::Probes watched(*scene.run, *scene::find_unit_system("SI"));
  const app::Prepared& run = *scene.run;
  Vec3 exact = Vec3::Zero();
  for (const model::NodeLine& node : run.state.nodes) {
    const Vec3 x = Vec3(Eigen::Map<const Vec3>(node.x)) + run.model.mesh.origin;
    exact += node.mass * x.cross(Vec3(1, 2, 3) + rate * axis.normalized().cross(x));
  }
  std::vector<double> row;
  for (int i = 0; i < 50; ++i) {
    scene.evaluate();
    watched.read_motion(*scene.run);
    scene.advance();
    row = watched.values(*scene.run, {}, scene.report.dt_mean);
    const Vec3 p(row[0], row[1], row[2]), q(row[3], row[4], row[5]), m(row[9], row[10], row[11]);
    CHECK((p - exact).norm() < 1e-12 * exact.norm());
    CHECK((q - (exact - Vec3(4, 5, 6).cross(m))).norm() < 1e-12 * exact.norm());
    CHECK((m - row[12] * (Vec3(1, 2, 3) + rate * axis.normalized().cross(Vec3(0, 0, 0.1)))).norm() < 1e-12 * m.norm());
  }
  CHECK(watched.columns()[0].unit == "N.s.m");
}
