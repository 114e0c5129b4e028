// SPDX-License-Identifier: Apache-2.0
// Graded elements, sectors and noses, as a scene writes them.
#include <fmt/format.h>

#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "scene/read/read.hpp"

using namespace brunt;
using namespace brunt::scene;

namespace {

Input with_mesh(const std::string& mesh, const std::string& more = "") {
  return read_scene(
      fmt::format("units: none\nmesh: {}\nmaterials: {{s: {{model: elastic, density: 1, young: 1, poisson: 0}}}}\n"
                  "parts: {{a: {{material: s}}}}\nrun: {{steps: 1}}\n{}",
                  mesh, more),
      "a.yaml");
}

Input box(const std::string& keys) {
  return with_mesh(fmt::format("{{box: {{part: a, size: [1, 2, 3], {}}}}}", keys));
}
Input cylinder(const std::string& keys) {
  return with_mesh(fmt::format("{{cylinder: {{part: a, radius: 2, length: 5, {}}}}}", keys));
}
Input tube(const std::string& keys) {
  return with_mesh(fmt::format("{{tube: {{part: a, outer_radius: 2, length: 5, {}}}}}", keys));
}

Input torus(const std::string& keys) {
  return with_mesh(fmt::format("{{torus: {{part: a, {}}}}}", keys));
}

const mesh::Nose& nose_of(const Input& input) {
  return std::get<CylinderMesh>(input.mesh[0].body).half.nose;
}

void require_fault(Input (*body)(const std::string&), const std::string& keys, const std::string& path,
                   const std::string& what) {
  INFO(keys);
  CHECK_THROWS_WITH(body(keys),
                    Catch::StartsWith("a.yaml:2: mesh.") && Catch::Contains(path + ": ") && Catch::Contains(what));
}

}  // namespace

TEST_CASE("bias and sizes of elements", "[scene]") {
  const Input input = box("elements: [4, [[0, 0.1], [1, 0.5]], 6], bias: [3, 1, 0.25]");
  const auto& elements = std::get<BoxMesh>(input.mesh[0].body).elements;
  CHECK(elements[0].bias == 3);
  CHECK(elements[1].sizes == std::vector<mesh::SizeAt>{{0, 0.1}, {1, 0.5}});
  CHECK(elements[1].cells == 6);
  CHECK(elements[2].bias == 0.25);
  CHECK(box("elements: [4, 5, 6]").mesh.size() == 1);
  CHECK(with_mesh("{plate: {part: a, size: [2, 2], thickness: 1, elements: [[[-1, 0.5], [0, 0.1]], 4, 2]}}")
            .mesh.size() == 1);
}

TEST_CASE("wrong bias and sizes are refused at their key", "[scene]") {
  const auto elements = [](const std::string& one) { return fmt::format("elements: [{}, 1, 1]", one); };
  require_fault(box, elements("[[0, 0.1], [0, 0.2]]"), "elements.0.1.0", "increasing places");
  require_fault(box, elements("[[0, 0.1], [1.5, 0.2]]"), "elements.0.1.0", "a place from 0 to 1 along x");
  require_fault(box, elements("[[0, -0.1]]"), "elements.0.0.1", "a number > 0");
  require_fault(box, elements("[[0, 0.1, 3]]"), "elements.0.0", "a pair [place, size]");
  require_fault(box, elements("[4, 2]"), "elements.0.0", "a pair [place, size]");
  require_fault(box, elements("[]"), "elements.0", "sizes [[place, size]");
  require_fault(box, elements("[[0, 1.0e-9]]"), "elements.0", "expected at most");
  require_fault(box, elements("{a: 1}"), "elements.0", "an integer from 1");
  require_fault(box, "elements: [1, 1, 1], bias: 3", "bias", "3 numbers > 0 [along x, along y, along z]");
  require_fault(box, "elements: [1, 1, 1], bias: [1, 0, 1]", "bias.1", "a number > 0");
  require_fault(box, "elements: [1, 1, 1], bias: [1, 1.0e9, 1]", "bias.1", "from 1e-6 to 1e6");
  require_fault(box, "elements: [[[0, 0.1]], 1, 1], bias: [2, 1, 1]", "bias.0", "already have sizes");
  require_fault(tube, "inner_radius: 1, elements: [1, [[0, 1]], 1]", "elements.1", "expected their number");
  require_fault(tube, "inner_radius: 1, elements: [1, 8, 1], bias: [1, 2, 1]", "bias.1", "expected 1");
  require_fault(tube, "inner_radius: 1, elements: [[[0.5, 1]], 8, 1]", "elements.0.0.0",
                "from 1 to 2 through the wall");
}

TEST_CASE("sectors", "[scene]") {
  const auto body = std::get<TubeMesh>(tube("inner_radius: 0, elements: [4, 2, 3], sector: [-2, 3]").mesh[0].body);
  CHECK(body.half.sector == mesh::Sector{-2, 3});
  CHECK(body.inner_radius == 0);
  require_fault(tube, "inner_radius: 0, elements: [4, 8, 3]", "inner_radius", "a number > 0");
  require_fault(tube, "inner_radius: 0, elements: [4, 2, 3], sector: [3, 3]", "sector", "a sector from 3 to 3");
  require_fault(tube, "inner_radius: 0, elements: [4, 2, 3], sector: [0, 360]", "sector", "less than 360 apart");
  require_fault(tube, "inner_radius: 0, elements: [4, 2, 3], sector: 5", "sector", "two angles in degrees");
  require_fault(tube, "inner_radius: 1, elements: [4, 8, 3], sector: [0, 5], half: [x]", "sector",
                "together with half");
  require_fault(tube, "inner_radius: 0, elements: [4, 1, 3], sector: [0, 90]", "elements", "at least 3 around");
  require_fault(cylinder, "elements: [4, 1], sector: [0, 9]", "sector", "a tube with inner_radius: 0");
}

TEST_CASE("a plane of symmetry is turned like a body", "[scene]") {
  const Input input = with_mesh("{box: {part: a, size: [1, 1, 1], elements: [1, 1, 1]}}",
                                "symmetry: [{point: [0, 0, 0], normal: [0, 2, 0], rotate: {axis: [0, 0, 1], degrees: "
                                "5}}]");
  const double angle = 5 * std::numbers::pi / 180;
  CHECK((input.symmetry[0].normal - Vec3(-std::sin(angle), std::cos(angle), 0)).norm() < 1e-15);
}

TEST_CASE("noses", "[scene]") {
  using Shape = mesh::Nose::Shape;
  const auto nose = [](const std::string& keys) {
    return nose_of(cylinder(fmt::format("elements: [4, 6], nose: {{shape: {}}}", keys)));
  };
  CHECK(nose("hemisphere") == mesh::Nose{.shape = Shape::hemisphere});
  CHECK(nose("cone, length: 3") == mesh::Nose{.shape = Shape::cone, .length = 3});
  CHECK(nose("cone, half_angle: 45").length == Approx(2));
  CHECK(nose("cone, half_angle: 45, tip_radius: 0.5").length == Approx(1.5));
  CHECK(nose("ogive, crh: 3, tip_radius: 0.2, elements: 7") ==
        mesh::Nose{.shape = Shape::ogive, .crh = 3, .tip_radius = 0.2, .elements = 7});
  CHECK(nose("blunt") == mesh::Nose{});
  CHECK(nose("blunt, chamfer: 0.5") == mesh::Nose{.shape = Shape::cone, .length = 0.5, .tip_radius = 1.5});
}

TEST_CASE("wrong noses are refused at their key", "[scene]") {
  const auto refuse = [](const std::string& nose, const std::string& path, const std::string& what) {
    require_fault(cylinder, fmt::format("elements: [4, 6], nose: {}", nose), path, what);
  };
  refuse("cone", "nose", "a map {shape:");
  refuse("{}", "nose.shape", "missing");
  refuse("{shape: con}", "nose.shape", "unknown value 'con' (did you mean 'cone'?)");
  refuse("{shape: cone}", "nose", "length and half_angle");
  refuse("{shape: cone, length: 1, half_angle: 3}", "nose.half_angle", "together with length");
  refuse("{shape: cone, half_angle: 90}", "nose.half_angle", "< 90 degrees");
  refuse("{shape: cone, length: 1, tip_radius: 2}", "nose.tip_radius", "a number > 0 and < 2");
  refuse("{shape: cone, length: 1, crh: 2}", "nose.crh", "unknown key");
  refuse("{shape: cone, length: 1, elements: 2}", "nose.elements", "invalid without tip_radius");
  refuse("{shape: hemisphere, tip_radius: 1}", "nose.tip_radius", "unknown key");
  refuse("{shape: ogive, crh: 0.4}", "nose.crh", "a number >= 0.5");
  refuse("{shape: blunt, chamfer: 2}", "nose.chamfer", "not below the radius");
  require_fault(tube, "inner_radius: 1, elements: [1, 8, 3], nose: {shape: hemisphere}", "elements", "at least 2");
}

TEST_CASE("tori", "[scene]") {
  const Input input = torus("radius: 76, tube: [19.5, 24], elements: [40, 20, 2]");
  const auto& body = std::get<TorusMesh>(input.mesh[0].body);
  CHECK(body.part == "a");
  CHECK(body.radius == 76);
  CHECK(body.tube == std::array{19.5, 24.0});
  CHECK(body.elements == std::array{40, 20, 2});
  const auto wrong = [](const std::string& keys, const char* path, const char* what) {
    require_fault(torus, keys, path, what);
  };
  wrong("radius: 76, tube: [24, 19.5], elements: [40, 20, 2]", "tube", "24; expected a larger number");
  wrong("radius: 76, tube: [24, 24], elements: [40, 20, 2]", "tube", "not larger than the inner radius");
  wrong("radius: 76, tube: [0, 24], elements: [40, 20, 2]", "tube.0", "a number > 0");
  wrong("radius: 76, tube: 24, elements: [40, 20, 2]", "tube", "two lengths > 0 [inner radius, outer radius]");
  wrong("radius: 24, tube: [19.5, 24], elements: [40, 20, 2]", "radius", "expected a number > 24");
  wrong("radius: -76, tube: [19.5, 24], elements: [40, 20, 2]", "radius", "a number > 0");
  wrong("radius: 76, tube: [19.5, 24], elements: [2, 20, 2]", "elements", "2 elements around the ring do not close");
  wrong("radius: 76, tube: [19.5, 24], elements: [40, 2, 2]", "elements", "2 elements around the tube do not close");
  wrong("radius: 76, tube: [19.5, 24], elements: [40, 20, 0]", "elements.2", "expected an integer from 1");
  wrong("radius: 76, tube: [19.5, 24], elements: [40, 20]", "elements", "around the ring, around the tube, through");
  wrong("radius: 76, tube: [19.5, 24], elements: [40, 20, 2], bias: [2, 1, 1]", "bias.0",
        "the elements around the ring are uniform");
  wrong("radius: 76, tube: [19.5, 24], elements: [40000, 40000, 9]", "elements", "out of range: 1.44e+10 elements");
  wrong("radius: 76, elements: [40, 20, 2]", "tube", "missing; expected two lengths");
}

TEST_CASE("bodies are turned once or more than once", "[scene]") {
  const auto turns = [](const std::string& rotate) {
    return torus("radius: 76, tube: [19.5, 24], elements: [40, 20, 2], at: [140, 0, 140]" + rotate)
        .mesh[0]
        .placement.rotate;
  };
  CHECK(turns("").empty());
  CHECK(turns(", rotate: {axis: [1, 0, 0], degrees: 90}").size() == 1);
  const auto two = turns(", rotate: [{axis: [1, 0, 0], degrees: 90}, {axis: [0, 0, 1], degrees: 45}]");
  REQUIRE(two.size() == 2);
  CHECK(two[0].degrees == 90);
  CHECK(two[1].axis == Vec3::UnitZ());
  CHECK(two[1].degrees == 45);
  const auto wrong = [&](const std::string& rotate, const char* path, const char* what) {
    CHECK_THROWS_WITH(turns(", rotate: " + rotate), Catch::StartsWith("a.yaml:2: mesh.torus.rotate") &&
                                                        Catch::Contains(path) && Catch::Contains(what));
  };
  wrong("[{axis: [1, 0, 0], degrees: 90}, {axis: [0, 0, 0], degrees: 45}]", "rotate.1.axis: ", "direction");
  wrong("[{axis: [1, 0, 0]}]", "rotate.0", "degrees");
  wrong("[90]", "rotate.0: ", "or a list of them");
  wrong("90", "rotate: ", "or a list of them");
}
