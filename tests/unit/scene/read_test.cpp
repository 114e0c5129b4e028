// SPDX-License-Identifier: Apache-2.0
#include "scene/read/read.hpp"

#include <fmt/format.h>

#include <catch2/catch.hpp>

#include "unit/scene/good_scene.hpp"

using namespace brunt;
using namespace brunt::scene;

namespace {

constexpr std::string_view full_scene = R"(
title: "everything: a scene"
units: mm-ms-kg
space: 3d
mesh:
  - {file: meshes/bar.exo, scale: 1.0e-3, at: [1, 2, 3], rotate: {axis: [0, 0, 2], degrees: 10}, prefix: a_}
  - {file: /else/b.msh}
  - {box: {part: left, size: [1, 2, 3], elements: [4, 5, 6], at: [-1, 0, 0], scale: 2, rotate: {axis: [1, 0, 0], degrees: -90}}}
  - {cylinder: {part: rod, radius: 3.2, length: 32.4, elements: [4, 20]}}
  - {sphere: {part: ball, radius: 5, elements: 6, finer: 3, half: [y, x]}}
  - {tube: {part: pipe, inner_radius: 1, outer_radius: 1.5, length: 10, elements: [2, 24, 10]}}
  - {plate: {part: target, size: [10, 20], thickness: 0.5, elements: [10, 20, 2]}}
sets:
  foot: {part: rod, box: [[0, 0, 0], [1, 1, 0.01]]}
  load: {side_set: 3}
  nodes: {node_set: top}
  corner: {box: [[0, 0, 0], [0, 0, 0]]}
curves: {ramp: [[0, 0], [1.0e-3, 1]], hold: [[0, 5]]}
materials:
  aluminium: {model: elastic, density: 2.7e-6, young: 70, poisson: 0.33}
  steel: {model: j2, density: 7.8e-6, young: 200, poisson: 0.3, yield: 0.4, hardening: 1, kinematic: 0.5, stress_rate: logarithmic}
  table: {model: j2, density: 7.8e-6, young: 200, poisson: 0.3, hardening_table: [[0, 0.4], [1, 0.5], [2, 0.5]]}
  rubber: {model: neo_hookean, density: 1.1e-6, bulk: 2, shear: 0.3}
  gum: {model: neo_hookean, density: 1.1e-6, young: 2.6, poisson: 0.3}
parts:
  bar: {block: 1, material: aluminium, element: hex8_full, hourglass: {kind: viscous}, bulk: {linear: 0, quadratic: 1.5}}
  odd: {block: Block 2, material: gum, element: tet4}
  left: {material: steel, hourglass: {kind: stiffness, coefficient: 0.1}}
  rod: {material: table, element: hex8_bbar}
  ball: {material: rubber}
  pipe: {material: steel, hourglass: {kind: none}}
  target: {material: steel, hourglass: {kind: viscous, coefficient: 0.15}}
initial:
  - {part: left, velocity: [0, 0, -227]}
  - {set: foot, rotation: {axis: [0, 3, 0], point: [1, 0, 0], rate: 75}}
fixed: [{set: foot, dofs: [x, z]}]
symmetry: [{point: [0, 0, 0], normal: [2, 0, 0]}]
prescribed:
  - {set: nodes, dof: z, velocity: ramp, scale: 5}
  - {part: rod, dof: x, velocity: -2.5, scale: 2}
pressure: [{set: load, value: 1.0e6, curve: ramp}]
gravity: {vector: [0, 0, -9.81e-3], curve: ramp}
damping: {alpha: 100, from: 1, to: 2}
remove: [{part: rod, at: 1.5e-3}, {set: foot, at: 0, nodes: drop}]
rigid_walls:
  - {point: [0, 0, 0], normal: [0, 0, 4], friction: 0}
  - {name: press, point: [0, 0, 9], normal: [0, 0, -1], bilateral: true, motion: ramp}
contact:
  - {between: all, exclude: [[rod, ball]], friction: {static: 0, kinetic: 0, decay: 0}, method: rate, passes: auto,
     slave: auto, tolerance: 1.0e-4, max_iterations: 20, softness: 0.1, initial_overlap: warn, thickness: auto}
  - {between: [rod, target], slave: target}
  - {between: [ball, target], slave: first, passes: two}
  - {between: [rod, ball]}
  - {between: [rod, target], passes: averaged}
probes:
  - {name: tip, node: 17, field: velocity}
  - {name: squeeze, contact: [rod, target]}
  - {name: wall, wall: press}
  - {name: foot, set: foot, field: reaction}
run: {end: 80.0e-6, steps: 1e4, cfl: 0.5, step_bound: element, wall_limit: 3h55m}
output: {every: 2.0e-6, fields: [displacement, velocity, stress, plastic_strain, contact_pressure, gap]}
history: {every: 1.0e-7}
checkpoint: {every: 20.0e-6}
)";

Input full() {
  return read_scene(std::string(full_scene), "folder/full.yaml");
}

Input read_with(const std::vector<std::string>& overrides) {
  return read_scene(std::string(small_scene), "small.yaml", overrides);
}

}  // namespace

TEST_CASE("a small scene is read with its defaults", "[scene]") {
  const Input input = read_scene(std::string(small_scene), "small.yaml");
  CHECK(input.file == "small.yaml");
  CHECK(input.units == "SI");
  REQUIRE(input.parts.size() == 2);
  const Part& left = input.parts[0];
  CHECK(left.block == "left");
  CHECK_FALSE(left.element);  // by the shape of the mesh
  CHECK(left.hourglass.kind == HourglassKind::stiffness);
  CHECK(left.hourglass.coefficient == 0.05);
  CHECK(left.bulk.linear == 0.06);
  CHECK(left.bulk.quadratic == 1.2);
  CHECK(input.mesh[0].placement.scale == 1);
  CHECK(input.mesh[0].placement.at == Vec3(0, 0, 0));
  CHECK(std::get<material::J2>(input.materials.at("steel")).hardening == 0);
  CHECK(input.rigid_walls[0].name == "wall0");
  CHECK_FALSE(input.rigid_walls[0].bilateral);
  CHECK(input.enforcement.settings.tolerance == 1e-3);
  CHECK(input.enforcement.settings.max_iterations == 200);
  CHECK(input.enforcement.settings.softness == 0);
  CHECK(input.enforcement.settings.softness_of_bodies == 0.05);
  CHECK(input.contact[0].initial_overlap == contact::OverlapRule::error);
  CHECK(input.run.end == 1e-3);
  CHECK_FALSE(input.run.steps);
  CHECK(input.run.step_bound == StepBound::assembled);
  CHECK_FALSE(input.history_every);
  CHECK(input.warnings.empty());
}

TEST_CASE("every mesh entry is read", "[scene]") {
  const Input input = full();
  REQUIRE(input.mesh.size() == 7);
  const auto& file = std::get<MeshFile>(input.mesh[0].body);
  CHECK(file.file == "folder/meshes/bar.exo");
  CHECK(file.prefix == "a_");
  CHECK(input.mesh[0].key == "mesh.0");
  CHECK(input.mesh[0].placement.scale == 1e-3);
  CHECK(input.mesh[0].placement.at == Vec3(1, 2, 3));
  CHECK(input.mesh[0].placement.rotate.at(0).axis == Vec3(0, 0, 1));
  CHECK(input.mesh[0].placement.rotate.at(0).degrees == 10);
  CHECK(std::get<MeshFile>(input.mesh[1].body).file == "/else/b.msh");
  const auto& box = std::get<BoxMesh>(input.mesh[2].body);
  CHECK(box.size == Vec3(1, 2, 3));
  CHECK(box.elements == std::array{4, 5, 6});
  CHECK(input.mesh[2].placement.rotate.at(0).degrees == -90);
  const auto& rod = std::get<CylinderMesh>(input.mesh[3].body);
  CHECK(rod.radius == 3.2);
  CHECK(rod.length == 32.4);
  CHECK(rod.elements == std::array{4, 20});
  const auto& ball = std::get<SphereMesh>(input.mesh[4].body);
  CHECK(ball.elements == 6);
  CHECK(ball.finer == 3);
  CHECK(ball.half == std::array<int, 3>{1, 1, 0});
  const auto& tube = std::get<TubeMesh>(input.mesh[5].body);
  CHECK(tube.inner_radius == 1);
  CHECK(tube.outer_radius == 1.5);
  CHECK(tube.elements == std::array{2, 24, 10});
  const auto& plate = std::get<PlateMesh>(input.mesh[6].body);
  CHECK(plate.size == std::array{10.0, 20.0});
  CHECK(plate.thickness == 0.5);
}

TEST_CASE("materials and parts are read", "[scene]") {
  const Input input = full();
  CHECK(std::get<material::Elastic>(input.materials.at("aluminium")).poisson == 0.33);
  const auto& steel = std::get<material::J2>(input.materials.at("steel"));
  CHECK(steel.hardening == 1);
  CHECK(steel.kinematic == 0.5);
  CHECK(steel.stress_rate == material::StressRate::logarithmic);
  CHECK(std::get<material::Elastic>(input.materials.at("aluminium")).stress_rate == material::StressRate::jaumann);
  const auto& table = std::get<material::J2>(input.materials.at("table"));
  CHECK(table.yield == 0.4);
  CHECK(table.table.size() == 3);
  const auto& rubber = std::get<material::NeoHookean>(input.materials.at("rubber"));
  CHECK(rubber.mu == 0.3);
  CHECK(rubber.lambda == Approx(1.8));  // K - 2/3 G
  const auto& gum = std::get<material::NeoHookean>(input.materials.at("gum"));
  CHECK(gum.mu == Approx(1.0));      // E / (2 (1 + nu)) = 2.6 / 2.6
  CHECK(gum.lambda == Approx(1.5));  // 2 mu nu / (1 - 2 nu) = 0.6 / 0.4
  REQUIRE(input.parts.size() == 7);
  CHECK(input.parts[0].block == "1");
  CHECK(input.parts[0].element == ElementKind::hex8_full);
  CHECK(input.parts[0].hourglass.coefficient == 0.1);
  CHECK(input.parts[0].bulk.linear == 0);
  CHECK(input.parts[1].block == "Block 2");
  CHECK(input.parts[1].element == ElementKind::tet4);
  CHECK(input.parts[2].hourglass.coefficient == 0.1);
  CHECK(input.parts[5].hourglass.kind == HourglassKind::none);
  CHECK(input.parts[6].hourglass.coefficient == 0.15);
}

TEST_CASE("sets, motions and loads are read", "[scene]") {
  const Input input = full();
  REQUIRE(input.sets.size() == 4);
  CHECK(input.sets[0].part == "rod");
  CHECK((*input.sets[0].box)[1] == Vec3(1, 1, 0.01));
  CHECK(input.sets[1].side_set == "3");
  CHECK(input.sets[2].node_set == "top");
  CHECK(input.curves.at("ramp")[1] == std::array{1e-3, 1.0});
  CHECK(input.initial[0].velocity == Vec3(0, 0, -227));
  CHECK(input.initial[1].where == "foot");
  CHECK(input.initial[1].spin_axis == Vec3(0, 1, 0));
  CHECK(input.initial[1].spin_rate == 75);
  CHECK(input.fixed[0].dofs == std::array{true, false, true});
  CHECK(input.symmetry[0].normal == Vec3(1, 0, 0));
  CHECK(input.prescribed[0].curve == "ramp");
  CHECK(input.prescribed[0].dof == 2);
  CHECK(input.prescribed[0].scale == 5);
  CHECK(input.prescribed[1].curve.empty());
  CHECK(input.prescribed[1].scale == -5);
  CHECK(input.pressure[0].value == 1e6);
  CHECK(input.gravity->vector == Vec3(0, 0, -9.81e-3));
  CHECK(input.damping->to == 2);
  REQUIRE(input.remove.size() == 2);
  CHECK(input.remove[0].where == "rod");
  CHECK(input.remove[0].at == 1.5e-3);
  CHECK(input.remove[0].keeps_nodes);
  CHECK(input.remove[1].where == "foot");
  CHECK_FALSE(input.remove[1].keeps_nodes);
  CHECK(input.rigid_walls[0].normal == Vec3(0, 0, 1));
  CHECK(input.rigid_walls[1].bilateral);
  CHECK(input.rigid_walls[1].motion == "ramp");
}

TEST_CASE("contact, probes and the run are read", "[scene]") {
  using Slave = ContactEntry::Slave;
  const Input input = full();
  REQUIRE(input.contact.size() == 5);
  CHECK(input.contact[0].between.empty());
  CHECK(input.contact[0].exclude[0] == std::array<std::string, 2>{"rod", "ball"});
  CHECK(input.enforcement.settings.tolerance == 1e-4);
  CHECK(input.enforcement.settings.max_iterations == 20);
  CHECK(input.enforcement.settings.softness == 0.1);
  CHECK(input.enforcement.settings.softness_of_bodies == 0.1);
  CHECK(input.contact[0].initial_overlap == contact::OverlapRule::warn);
  CHECK(input.contact[1].slave == Slave::second);
  CHECK(input.contact[2].slave == Slave::first);
  CHECK(input.contact[1].passes == contact::Passes::automatic);
  CHECK(input.contact[2].passes == contact::Passes::two);
  CHECK(input.contact[3].passes == contact::Passes::automatic);  // whatever the entry before has
  CHECK(input.contact[3].slave == Slave::automatic);
  CHECK(input.contact[4].passes == contact::Passes::averaged);
  REQUIRE(input.probes.size() == 4);
  CHECK(input.probes[0].where == "17");
  CHECK(input.probes[1].kind == Probe::Kind::contact);
  CHECK(input.probes[1].other == "target");
  CHECK(input.probes[2].where == "press");
  CHECK(input.probes[3].field == "reaction");
  CHECK(input.run.end == 80e-6);
  CHECK(input.run.steps == 10000);
  CHECK(input.run.cfl == 0.5);
  CHECK(input.run.step_bound == StepBound::element);
  CHECK(input.run.wall_limit == 14100);
  CHECK(input.output.fields.size() == 6);
  CHECK(input.history_every == 1e-7);
  CHECK(input.checkpoint_every == 20e-6);
}

TEST_CASE("overrides change, create and take away", "[scene]") {
  const std::vector<std::string> overrides{"mesh.0.box.elements=[40, 40, 40]", "run.end=1e-5", "history.every=1e-7",
                                           "materials.steel.yield=3e8",        "contact=null", "run.end=2e-5"};
  const Input input = read_scene(std::string(small_scene), "small.yaml", overrides);
  CHECK(std::get<BoxMesh>(input.mesh[0].body).elements == std::array{40, 40, 40});
  CHECK(input.run.end == 2e-5);
  CHECK(input.history_every == 1e-7);
  CHECK(std::get<material::J2>(input.materials.at("steel")).yield == 3e8);
  CHECK(input.contact.empty());
}

TEST_CASE("a mesh of one body needs no list, and its overrides no change", "[scene]") {
  const std::string text = R"(units: none
mesh: {box: {part: a, size: [1, 1, 1], elements: [1, 1, 1]}}
materials: {m: {model: elastic, density: 1, young: 1, poisson: 0}}
parts: {a: {material: m}}
run: {steps: 4}
)";
  const std::vector<std::string> overrides{"mesh.0.box.elements=[2, 3, 4]"};
  const Input input = read_scene(text, "one.yaml", overrides);
  REQUIRE(input.mesh.size() == 1);
  CHECK(std::get<BoxMesh>(input.mesh[0].body).elements == std::array{2, 3, 4});
  CHECK(input.run.steps == 4);
}

TEST_CASE("a density that no matter has draws a warning", "[scene]") {
  const auto told = [](const std::string& units, const std::string& density) {
    const std::vector<std::string> overrides{"units=" + units, "materials.steel.density=" + density};
    const Input input = read_scene(std::string(small_scene), "small.yaml", overrides);
    REQUIRE(input.warnings.size() == 1);  // and none of the speed of waves, which follows from it
    return input.warnings[0];
  };
  CHECK_THAT(told("mm-s-tonne", "7800"),
             Catch::Contains("density: 7800 t/mm^3 (7.8e+15 kg/m^3) is outside the densities of known matter") &&
                 Catch::Contains("in kg/m^3, of units SI, it would be 7800 kg/m^3"));
  CHECK_THAT(told("SI", "7.8e-9"),
             Catch::Contains("density: 7.8e-09 kg/m^3 is outside the densities of known matter, 1 to") &&
                 Catch::Contains("in t/mm^3, of units mm-s-tonne, it would be 7800 kg/m^3"));
  CHECK_THAT(told("in-s-lbf", "0.283"), Catch::Contains("a weight of 0.283 lbf/in^3") &&
                                            Catch::Contains("0.000733 lbf.s^2/in^4 (divide by 386.09 in/s^2)"));
  CHECK_THAT(told("ft-s-lbf", "490"), Catch::Contains("a weight of 490 lbf/ft^3 is a density of 15.23 slug/ft^3"));
  CHECK_THAT(told("in-s-lbf", "7.85"), Catch::Contains("in g/cm^3, of units cm-us-g, it would be 7850 kg/m^3"));
  CHECK_THAT(told("SI", "1e40"), !Catch::Contains("would"));
}

TEST_CASE("a speed of waves that no matter has draws a warning with the speed and the likely cause", "[scene]") {
  const auto warnings = [](const std::string& units, const std::string& density, const std::string& young) {
    const std::vector<std::string> overrides{"units=" + units, "materials.steel.density=" + density,
                                             "materials.steel.young=" + young};
    return read_scene(std::string(small_scene), "small.yaml", overrides).warnings;
  };
  CHECK(warnings("SI", "7800", "2.0e11").empty());
  CHECK(warnings("mm-s-tonne", "7.8e-9", "2.0e5").empty());
  CHECK(warnings("none", "7800", "2.0").empty());
  CHECK(warnings("SI", "1100", "1.0e6").empty());  // soft rubber
  // sqrt(E (1 - nu) / ((1 + nu) (1 - 2 nu)) / rho) with nu = 0.3: 5875 m/s for steel
  const std::vector<std::string> mega = warnings("SI", "7800", "2.0e5");
  REQUIRE(mega.size() == 1);
  CHECK_THAT(mega[0], Catch::Contains("materials.steel.young: ") && Catch::Contains("a wave speed of 5.88 m/s") &&
                          Catch::Contains("stresses are in Pa here: with young in MPa the wave speed is 5.88e+03 m/s"));
  const std::vector<std::string> giga = warnings("SI", "7800", "2.0e2");
  REQUIRE(giga.size() == 1);
  CHECK_THAT(giga[0], Catch::Contains("0.186 m/s") && Catch::Contains("in GPa"));
  CHECK(warnings("in-s-lbf", "7.33e-4", "3.0e7").empty());
  CHECK(warnings("in-s-lbf", "1.0e-4", "200").empty());  // soft rubber
  for (const auto& [young, unit] : {std::pair{"29000", "ksi"}, {"29", "Msi"}, {"2.0e11", "Pa"}, {"200", "GPa"}}) {
    const std::vector<std::string> american = warnings("in-s-lbf", "7.33e-4", young);
    REQUIRE(american.size() == 1);
    CHECK_THAT(american[0],
               Catch::Contains(fmt::format("stresses are in psi here: with young in {} the wave speed", unit)));
  }
  const std::vector<std::string> pascal = warnings("mm-s-tonne", "7.8e-9", "2.0e11");
  REQUIRE(pascal.size() == 1);
  CHECK_THAT(pascal[0],
             Catch::Contains("5.88e+06 m/s") && Catch::Contains("stresses are in MPa here: with young in Pa"));
}

TEST_CASE("friction and methods are read; what would do nothing draws a warning", "[scene]") {
  const std::vector<std::string> overrides{
      "contact=[{between: all, friction: {static: 0.3, kinetic: 0.1}, method: kinematic, stiffness: 1},"
      "{between: [left, right], friction: {static: 0.4, kinetic: 0.2, decay: 3, lag: 0.5}}]",
      "rigid_walls.0.friction=0.5"};
  const Input input = read_scene(std::string(small_scene), "small.yaml", overrides);
  REQUIRE(input.contact.size() == 2);
  CHECK(input.contact[0].friction.coefficient(1e9) == 0.3);
  CHECK(input.contact[1].friction.coefficient(0) == 0.4);
  CHECK(input.contact[1].friction.coefficient(1e9) == 0.2);
  CHECK(input.contact[1].friction.lag == 0.5);
  CHECK(input.enforcement.settings.method == contact::Method::kinematic);  // kept from the entry before
  CHECK(input.rigid_walls[0].friction.kinetic == 0.5);
  REQUIRE(input.warnings.size() == 2);
  CHECK_THAT(input.warnings[0], Catch::Contains("contact.0.stiffness: no effect except with method"));
  CHECK_THAT(input.warnings[1], Catch::Contains("contact.0.friction: kinetic has no effect without decay"));
}

TEST_CASE("enforcement is a section of its own; entries of contact may say the same", "[scene]") {
  const Input input = read_with(
      {"enforcement={method: row_sum, tolerance: 1e-5, max_iterations: 7, softness: 0, competing: nearest, rebuild: 3}",
       "contact.0.tolerance=1.0e-5"});
  CHECK(input.warnings.empty());
  CHECK(input.enforcement.settings.method == contact::Method::row_sum);
  CHECK(input.enforcement.settings.tolerance == 1e-5);
  CHECK(input.enforcement.settings.max_iterations == 7);
  CHECK(input.enforcement.settings.softness == 0);
  CHECK(input.enforcement.competing == contact::Criterion::nearest);
  CHECK(input.enforcement.rebuild == contact::Rebuild{contact::Rebuild::When::every, 3});

  const Input mixed =
      read_with({"enforcement.tolerance=1e-6", "contact.0.method=kinematic", "enforcement.partition=0.5"});
  CHECK(mixed.warnings.empty());  // the entry's method uses the section's figure
  CHECK(mixed.enforcement.settings.method == contact::Method::kinematic);
  CHECK(mixed.enforcement.settings.tolerance == 1e-6);
  CHECK(mixed.enforcement.settings.partition == 0.5);

  CHECK(read_with({"contact=null", "enforcement.max_iterations=9"}).enforcement.settings.max_iterations == 9);  // walls
  const Input useless = read_with({"contact=null", "rigid_walls=null", "enforcement.damping=0.2"});
  REQUIRE(useless.warnings.size() == 2);
  CHECK_THAT(useless.warnings[0], Catch::Contains("enforcement: no effect without contact or rigid_walls"));
  CHECK_THAT(useless.warnings[1], Catch::Contains("enforcement.damping: no effect except with method penalty"));
}

TEST_CASE("softness does nothing where passes are averaged, and a warning says so", "[scene]") {
  const Input averaged = read_with({"contact.0.slave=auto", "contact.0.passes=averaged", "contact.0.softness=0.1"});
  REQUIRE(averaged.warnings.size() == 1);
  CHECK_THAT(averaged.warnings[0], Catch::Contains("contact.0.softness: no effect where a contact has passes"));
  CHECK(read_with({"contact.0.slave=auto", "contact.0.passes=two", "contact.0.softness=0.1"}).warnings.empty());
  CHECK(read_with({"contact.0.slave=auto", "contact.0.passes=averaged", "contact.0.softness=0"}).warnings.empty());
  CHECK(read_with({"contact.0.slave=auto", "contact.0.passes=averaged", "enforcement.softness=0.1"}).warnings.size() ==
        1);
}

TEST_CASE("keys of deformable elements on a rigid part draw a warning", "[scene]") {
  const Input input = read_with({"materials.hard={model: rigid, density: 7800}",
                                 "parts.right={material: hard, element: tet4, bulk: {linear: 0}}"});
  REQUIRE(input.warnings.size() == 2);
  CHECK_THAT(input.warnings[0], Catch::Contains("parts.right.element: no effect, since the part is rigid"));
  CHECK_THAT(input.warnings[1], Catch::Contains("parts.right.bulk: no effect, since the part is rigid"));
}

TEST_CASE("a probe of contact between parts that nothing lets touch is a fault", "[scene]") {
  const std::string probe = "probes=[{name: p, contact: [left, right]}]";
  CHECK_THROWS_WITH(read_with({"contact=[{between: all, exclude: [[right, left]]}]", probe}),
                    Catch::Contains("no entry of contact covers 'left' and 'right'; expected "));
  CHECK_NOTHROW(read_with({"contact=[{between: [right, left]}]", probe}));
}
