// SPDX-License-Identifier: Apache-2.0
// Keys of shells: bodies, parts, supports, loads; which part has which element.
#include <fmt/format.h>

#include <catch2/catch.hpp>

#include "core/error.hpp"
#include "mesh/primitives.hpp"
#include "mesh/shell_bodies.hpp"
#include "scene/build/select.hpp"
#include "scene/read/read.hpp"

using namespace brunt;
using namespace brunt::scene;
using Catch::Contains;

namespace {

Input with(const std::string& part, const std::string& more = "",
           const std::string& body = "plate: {part: skin, size: [4, 2], elements: [4, 2], shell: true}") {
  return read_scene(fmt::format("units: SI\nmesh:\n  - {{{}}}\n  - {{box: {{part: cube, size: [1, 1, 1], elements: "
                                "[1, 1, 1]}}}}\nmaterials: {{m: {{model: elastic, density: 1, young: 1, poisson: "
                                "0}}}}\nparts: {{skin: {{material: m, {}}}, cube: {{material: m}}}}\nrun: {{end: "
                                "1}}\n{}",
                                body, part, more),
                    "shell.yaml", {});
}

mesh::Mesh mesh_of(const std::string& part, mesh::Shape shape) {
  mesh::Mesh mesh = mesh::shell_plate(part, {4, 2}, {4, 2});
  if (shape == mesh::Shape::tri3) mesh::split_into_triangles(mesh);
  return shape == mesh::Shape::hex8 ? mesh::box(part, Vec3(1, 1, 1), {1, 1, 1}) : mesh;
}

}  // namespace

TEST_CASE("the section of a shell", "[scene]") {
  const Part part = with("thickness: 0.2").parts[0];
  CHECK(is_shell(part));
  CHECK(part.section.thickness == 0.2);
  CHECK(part.section.points == 5);
  CHECK(part.section.rule == element::ThicknessRule::gauss);
  CHECK(part.section.offset == 0);
  CHECK(part.section.thinning);
  CHECK(part.section.warping);
  const Part all = with(
                       "thickness: 1, points: 2, rule: lobatto, offset: -0.5, thinning: false, warping: false, "
                       "element: shell4_full")
                       .parts[0];
  CHECK(all.section.points == 2);
  CHECK(all.section.rule == element::ThicknessRule::lobatto);
  CHECK(all.section.offset == -0.5);
  CHECK_FALSE(all.section.thinning);
  CHECK_FALSE(all.section.warping);
  CHECK(all.element == ElementKind::shell4_full);
  CHECK_FALSE(is_shell(with("thickness: 0.2").parts[1]));
}

TEST_CASE("the element of a part by the shape of its block", "[scene]") {
  using mesh::Shape;
  const Part skin = with("thickness: 0.2").parts[0], full = with("thickness: 0.2, element: shell4_full").parts[0];
  CHECK(kind_of(skin, Shape::quad4) == ElementKind::shell4);
  CHECK(kind_of(skin, Shape::tri3) == ElementKind::shell3);
  CHECK(kind_of(full, Shape::quad4) == ElementKind::shell4_full);
  CHECK(kind_of(with("thickness: 0.2").parts[1], Shape::hex8) == ElementKind::hex8);
}

TEST_CASE("a part of shells must fit its block", "[scene]") {
  using mesh::Shape;
  const auto fault_of = [](const std::string& part, Shape shape) -> std::string {
    Input input = with("thickness: 1");
    input.parts = {with(part).parts[0]};
    try {
      parts_of_blocks(input, mesh_of("skin", shape));
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  };
  CHECK(fault_of("thickness: 1", Shape::quad4).empty());
  CHECK(fault_of("thickness: 1", Shape::tri3).empty());
  CHECK(fault_of("thickness: 1, element: shell3", Shape::tri3).empty());
  CHECK_THAT(fault_of("thickness: 1, element: shell3", Shape::quad4), Contains("expected shell4 or shell4_full"));
  CHECK_THAT(fault_of("thickness: 1, element: shell4", Shape::tri3), Contains("expected shell3"));
  CHECK_THAT(fault_of("thickness: 1", Shape::hex8), Contains("invalid thickness: the elements of the block are solid"));
  CHECK_THAT(fault_of("block: skin", Shape::quad4), Contains("missing thickness: the block has shells"));
}

TEST_CASE("bodies of shells", "[scene]") {
  const auto plate = std::get<PlateMesh>(with("thickness: 1").mesh[0].body);
  CHECK(plate.shell);
  CHECK(plate.elements[0].cells == 4);
  CHECK(plate.elements[1].cells == 2);
  const auto box =
      std::get<BoxMesh>(with("thickness: 1", "",
                             "box: {part: skin, size: [1, 2, 3], elements: [1, 2, 3], shell: true, open: [zmax, xmin]}")
                            .mesh[0]
                            .body);
  CHECK(box.shell);
  CHECK(box.open == mesh::BoxSides{true, false, false, false, false, true});
  const auto tube = std::get<TubeMesh>(with("thickness: 1", "",
                                            "tube: {part: skin, inner_radius: 1, outer_radius: 2, length: 3, elements: "
                                            "[1, 12, 4], shell: true, quarter: [x, y]}")
                                           .mesh[0]
                                           .body);
  CHECK(tube.shell);
  CHECK(std::get<SphereMesh>(
            with("thickness: 1", "", "sphere: {part: skin, radius: 1, elements: 4, shell: true}").mesh[0].body)
            .shell);
  CHECK_FALSE(std::get<BoxMesh>(with("thickness: 1").mesh[1].body).shell);
}

TEST_CASE("rotations and moments on nodes of shells", "[scene]") {
  const Input input = with("thickness: 1",
                           "fixed: [{set: skin_xmin, dofs: [x, rx, rz]}]\nprescribed: [{set: skin_xmax, dof: ry, "
                           "velocity: 2}]\nforces: [{set: skin_ymax, moment: [0, 1, 2]}, {set: skin_ymin, force: [3, "
                           "0, 0], moment: [4, 0, 0]}]\n");
  CHECK(input.fixed[0].dofs == std::array{true, false, false});
  CHECK(input.fixed[0].turns == std::array{true, false, true});
  CHECK(input.prescribed[0].dof == 4);
  CHECK(input.forces[0].value == Vec3::Zero());
  CHECK(input.forces[0].moment == Vec3(0, 1, 2));
  CHECK(input.forces[0].kind == DeadLoad::Kind::each_node);
  CHECK(input.forces[1].value == Vec3(3, 0, 0));
  CHECK(input.forces[1].moment == Vec3(4, 0, 0));
}

TEST_CASE("contact beside shells that names solid parts", "[scene]") {
  CHECK_NOTHROW(with("thickness: 1", "contact: [{between: [cube, cube]}]\n"));
  CHECK_NOTHROW(with("thickness: 1", "contact: [{between: all, exclude: [[skin, skin], [skin, cube]]}]\n"));
  CHECK_THROWS_WITH(with("thickness: 1", "contact: [{between: all, exclude: [[skin, cube]]}]\n"),
                    Contains("part 'skin' has shells"));
}
