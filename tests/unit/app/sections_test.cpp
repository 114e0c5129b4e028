// SPDX-License-Identifier: Apache-2.0
// Forces and moments through sections of bars whose loads are known.
#include "app/report/sections.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <catch2/catch.hpp>
#include <cmath>

#include "app/report/probes.hpp"
#include "core/error.hpp"
#include "prepared_scene.hpp"
#include "time/relaxation.hpp"

using namespace brunt;

namespace {

/// A bar of length 2 and 0.5 x 0.25 across, held at its foot x = 0, turned by some degrees about z.
std::string bar(double degrees, const std::string& loads) {
  return fmt::format(
             "units: SI\nmesh: {{box: {{part: bar, size: [2, 0.5, 0.25], elements: [8, 2, 2], rotate: {{axis: [0, 0, "
             "1], degrees: {}}}}}}}\n"
             "materials: {{m: {{model: elastic, density: 1000, young: 1.0e8, poisson: 0.25}}}}\n"
             "parts: {{bar: {{material: m, element: hex8_bbar}}}}\nfixed: [{{set: bar_xmin, dofs: [x, y, z]}}]\nrun: "
             "{{end: 1}}\n"
             "relaxation: {{tolerance: 1.0e-5}}\n",
             degrees) +
         loads;
}

/// The row of the probes in the static state.
std::vector<double> at_rest(support::PreparedScene& scene) {
  app::Prepared& run = *scene.run;
  app::Probes watched(run, *scene::find_unit_system("SI"));
  bool done = false;
  while (!done && run.state.relaxation.steps < 60000)
    done = time::relax(run.model, run.state, run.scratch, run.links, nullptr, {0.9, 1.02}, {1e-5}).at_rest;
  CHECK(done);
  app::begin_run(run);
  scene.evaluate();
  watched.read_motion(run);
  scene.advance();
  return watched.values(run, {}, scene.report.dt_mean);
}

}  // namespace

TEST_CASE("sections: a bar in tension hands on pressure times area, through planes at nodes and between them") {
  const double degrees = GENERATE(0.0, 30.0);
  const double place = GENERATE(0.0, 0.6, 1.0, 1.9);  // 1.0 lies on nodes
  const double a = degrees * std::acos(-1.0) / 180;
  const Vec3 along(std::cos(a), std::sin(a), 0);
  support::PreparedScene scene(bar(
      degrees,
      "pressure: [{set: bar_xmax, value: -1000}]\n" +
          fmt::format("probes: [{{name: cut, section: {{part: bar, point: [{}, {}, 0.1], normal: [{}, {}, 0]}}}}]\n",
                      place * along[0], place * along[1], along[0], along[1])));
  const std::vector<double> row = at_rest(scene);
  const Vec3 force(row[0], row[1], row[2]), moment(row[3], row[4], row[5]);
  CHECK((force - 1000 * 0.125 * along).norm() < 2e-3 * 125);
  CHECK(moment.norm() < 2e-3 * 125 * 0.25);
}

TEST_CASE("sections: a hanging bar hands on the weight of the nodes behind, a cantilever the moment of its load") {
  support::PreparedScene hanging(
      bar(0,
          "gravity: {vector: [3, 0, 0]}\n"
          "probes: [{name: cut, section: {part: bar, point: [0.8, 0, 0], normal: [-1, 0, 0]}}]\n"));
  const std::vector<double> weight = at_rest(hanging);
  // behind the plane, seen along -x, lie the layers of nodes at x = 1 to 2: four elements and a half
  CHECK(weight[0] == Approx(-3 * 1000 * 0.125 * (2 - 1 + 0.125)).epsilon(1e-3));
  support::PreparedScene beam(bar(0,
                                  "forces: [{set: bar_xmax, total: [0, 0, -2]}]\n"
                                  "probes: [{name: cut, section: {part: bar, point: [0.75, 0, 0], normal: [1, 0, 0], "
                                  "about: [0.75, 0.25, 0.125]}},\n"
                                  "  {name: own, section: {part: bar, point: [0.75, 0, 0], normal: [1, 0, 0]}},\n"
                                  "  {name: foot, section: {part: bar, set: bar_xmin}}]\n"));
  const std::vector<double> row = at_rest(beam);
  CHECK(row[2] == Approx(-2).epsilon(2e-3));
  CHECK(row[4] == Approx(2 * 1.25).epsilon(2e-3));  // r x F = 1.25 ex x -2 ez = 2.5 ey
  CHECK(row[10] == Approx(row[4]).epsilon(1e-3));
  CHECK(row[14] == Approx(-2).epsilon(2e-3));
  CHECK(row[16] == Approx(2 * 2).epsilon(2e-3));
}

TEST_CASE("sections: the force is what changes the momentum of the nodes behind, in any motion") {
  support::PreparedScene scene(
      "units: SI\nmesh: {cylinder: {part: rod, radius: 0.3, length: 2, elements: [2, 8]}}\n"
      "materials: {m: {model: neo_hookean, density: 3, young: 100, poisson: 0.3}}\nparts: {rod: {material: m}}\n"
      "sets: {head: {part: rod, box: [[-1, -1, 1.5], [1, 1, 2]]}}\n"
      "initial: [{set: head, velocity: [1, -0.5, -2]}]\nrun: {end: 1}\n"
      "probes: [{name: cut, section: {part: rod, point: [0, 0, 0.9], normal: [0.2, 0.1, 1]}}]\n");
  app::Prepared& run = *scene.run;
  app::Probes watched(run, *scene::find_unit_system("SI"));
  const Vec3 normal = Vec3(0.2, 0.1, 1).normalized(), point(0, 0, 0.9);
  const auto behind = [&] {
    Vec3 momentum = Vec3::Zero();
    for (std::size_t i = 0; i < run.state.nodes.size(); ++i)
      if ((run.model.mesh.coordinates[i] + run.model.mesh.origin - point).dot(normal) <= 1e-9)
        momentum += run.state.nodes[i].mass * Eigen::Map<const Vec3>(run.state.nodes[i].v);
    return momentum;
  };
  for (int i = 0; i < 40; ++i) {
    const Vec3 before = behind();
    scene.evaluate();
    watched.read_motion(run);
    scene.advance();
    const std::vector<double> row = watched.values(run, {}, scene.report.dt_mean);
    CHECK((behind() - before - scene.report.dt_mean * Vec3(row[0], row[1], row[2])).norm() < 1e-14);
  }
}

TEST_CASE("probes near a place: the nearest node, of equal ones the smallest number, of a part if asked") {
  const std::string scene =
      "units: SI\nmesh:\n  - {box: {part: a, size: [1, 1, 1], elements: [1, 1, 1]}}\n"
      "  - {box: {part: b, size: [1, 1, 1], elements: [1, 1, 1], at: [1, 0, 0]}}\n"
      "materials: {m: {model: elastic, density: 3, young: 100, poisson: 0.3}}\nparts: {a: {material: m}, b: {material: "
      "m}}\n"
      "run: {end: 1}\nprobes: [{name: any, near: [1.1, 0.1, 0], field: position}, {name: of_b, part: b, near: [-3, 0, "
      "0], field: position},\n"
      "  {name: middle, near: [0.5, 0.5, 0.5], field: position}]\n";
  support::PreparedScene prepared(scene);
  app::Probes watched(*prepared.run, *scene::find_unit_system("SI"));
  watched.read_motion(*prepared.run);
  const std::vector<double> row = watched.values(*prepared.run, {});
  CHECK(row == std::vector<double>{1, 0, 0, 1, 0, 0, 0, 0, 0});
  const std::vector<std::string>& notes = prepared.run->overlaps.report.notes;
  REQUIRE(notes.size() == 3);
  CHECK(notes[0].find("probe any: node 2 at (1, 0, 0), at a distance of 0.1414 m") != std::string::npos);
}
