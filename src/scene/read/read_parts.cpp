// SPDX-License-Identifier: Apache-2.0
// Parts (what a block of the mesh is made of), named sets, curves.
#include <fmt/format.h>

#include <Eigen/Eigenvalues>

#include "scene/read/sections.hpp"

namespace brunt::scene {
namespace {

const Choices<ElementKind> element_kinds{{{"hex8", ElementKind::hex8},
                                          {"hex8_full", ElementKind::hex8_full},
                                          {"hex8_bbar", ElementKind::hex8_bbar},
                                          {"tet4", ElementKind::tet4}},
                                         {"shell4", "quad4"}};
const Choices<HourglassKind> hourglass_kinds{{{"none", HourglassKind::none},
                                              {"viscous", HourglassKind::viscous},
                                              {"stiffness", HourglassKind::stiffness},
                                              {"elastic", HourglassKind::elastic}},
                                             {}};

void read_hourglass(const Key& key, Hourglass& hourglass) {
  Section section(key, "a map {kind: none, viscous, stiffness or elastic, coefficient: number}");
  section.optional("kind", hourglass.kind, hourglass_kinds);
  constexpr double default_viscous = 0.1, default_stiffness = 0.05;
  hourglass.coefficient = hourglass.kind == HourglassKind::viscous ? default_viscous : default_stiffness;
  if (hourglass.kind == HourglassKind::none) hourglass.coefficient = 0;
  section.optional("coefficient", hourglass.coefficient, share);
}

void read_bulk(const Key& key, BulkViscosity& bulk) {
  Section section(key, "a map {linear: number, quadratic: number}");
  section.optional("linear", bulk.linear, not_negative);
  section.optional("quadratic", bulk.quadratic, not_negative);
}

/// The tensor of [xx, yy, zz, xy, yz, zx]. Principal moments of a mass distribution are not negative, and none exceeds
/// the sum of the others. A zero moment would allow no rotation about its axis.
void read_inertia(const Key& key, RigidGiven& given) {
  constexpr std::string_view expected = "[xx, yy, zz, xy, yz, zx] about the centre";
  std::array<double, 6> value{};
  if (!read(key, value, any_number, expected)) return;
  Mat3 tensor;
  tensor << value[0], value[3], value[5],  //
      value[3], value[1], value[4],        //
      value[5], value[4], value[2];
  const Vec3 moments = Eigen::SelfAdjointEigenSolver<Mat3>(tensor, Eigen::EigenvaluesOnly).eigenvalues();
  constexpr double rounding = 1e-9;
  const bool positive_moments = moments[0] > rounding * moments[2];
  const bool of_masses = moments[0] + moments[1] >= (1 - rounding) * moments[2];
  if (positive_moments && of_masses)
    given.inertia = tensor;
  else
    fault(key, fmt::format("invalid inertia: the principal moments are {:g}, {:g}, {:g}; expected moments > 0, each at "
                           "most the sum of the other two",
                           moments[0], moments[1], moments[2]));
}

RigidGiven read_rigid(const Key& key) {
  RigidGiven given;
  Section section(key, "a map {mass: number, centre: [x, y, z], inertia: [xx, yy, zz, xy, yz, zx]}, or {joins: part}");
  section.optional("mass", given.mass, positive);
  if (section.has("centre")) {
    Vec3 centre = Vec3::Zero();
    if (section.required("centre", centre, Vector::any)) given.centre = centre;
  }
  if (section.has("inertia")) read_inertia(section.at("inertia"), given);
  if (section.has("reference")) {
    Vec3 reference = Vec3::Zero();
    if (section.required("reference", reference, Vector::any)) given.reference = reference;
  }
  section.optional("joins", given.joins, Named::part);
  return given;
}

Part read_part(const std::string& name, Section& section) {
  Part part;
  part.name = part.block = name;
  section.optional("block", part.block, "the name or number of a block of the mesh");
  section.required("material", part.material, Named::material);
  section.optional("element", part.element, element_kinds);
  if (section.has("hourglass")) read_hourglass(section.at("hourglass"), part.hourglass);
  if (section.has("bulk")) read_bulk(section.at("bulk"), part.bulk);
  section.not_yet("thickness", "no thickness for solid elements");
  if (section.has("rigid")) part.rigid = read_rigid(section.at("rigid"));
  if (section.has("erosion")) part.erosion = read_erosion(section.at("erosion"));
  return part;
}

void read_box(const Key& key, SetEntry& set) {
  constexpr std::string_view expected = "two corners [[x, y, z], [x, y, z]], the lower one first";
  const std::vector<Key> corners = items(key, expected, 2);
  std::array<Vec3, 2> box{Vec3::Zero(), Vec3::Zero()};
  if (corners.size() != 2 || !read(corners[0], box[0], Vector::any) || !read(corners[1], box[1], Vector::any)) return;
  if ((box[0].array() > box[1].array()).any())
    return fault(key, fmt::format("invalid box: a lower bound exceeds the upper one; expected {}", expected));
  set.box = box;
}

SetEntry read_set(const std::string& name, const Key& key) {
  SetEntry set;
  set.name = name;
  Section section(key, "a map with one of part, node_set, side_set, or with a box");
  std::string word;
  int sources = 0;
  if (section.has("part")) {
    if (section.required("part", word, Named::part)) set.part = word;
    ++sources;
  }
  if (section.has("node_set")) {
    if (section.required("node_set", word, "the name or number of a node set")) set.node_set = word;
    ++sources;
  }
  if (section.has("side_set")) {
    if (section.required("side_set", word, "the name or number of a side set")) set.side_set = word;
    ++sources;
  }
  const bool has_box = section.has("box");
  if (has_box) read_box(section.at("box"), set);
  const bool box_of_other = has_box && (section.has("node_set") || section.has("side_set"));
  constexpr std::string_view what =
      "invalid selection; expected one of part, node_set, side_set, or a box, alone or with part";
  if (section.is_map() && (sources > 1 || box_of_other)) fault(key, what);
  if (section.is_map() && sources == 0 && !has_box) lacking(key, {"part", "node_set", "side_set", "box"}, what);
  return set;
}

Curve read_curve(const Key& key) {
  constexpr std::string_view expected = "a list of points [time, value], times increasing";
  Curve curve;
  const std::vector<Key> rows = items(key, expected);
  for (const Key& row : rows) {
    std::array<double, 2> point{};
    if (!read(row, point, any_number, "a point [time, value]")) break;
    if (!curve.empty() && point[0] <= curve.back()[0]) {
      fault(row,
            fmt::format("invalid time {}: not later than the time before it, {}; expected strictly increasing times",
                        point[0], curve.back()[0]));
      break;
    }
    curve.push_back(point);
  }
  if (key.tree->kind == Tree::Kind::list && rows.empty()) wrong(key, expected);
  return curve;
}

}  // namespace

void read_parts(Section& scene, Input& input) {
  for (const auto& [name, key] : entries(scene.at("parts"), "a map of names, each {material: name, ...}")) {
    Section section(key, "a map {material: name, ...}");
    input.parts.push_back(read_part(name, section));
    if (section.has("erosion")) check_erosion(input, input.parts.back(), section.at("erosion"));
  }
}

void read_sets(Section& scene, Input& input) {
  if (!scene.has("sets")) return;
  for (const auto& [name, key] : entries(scene.at("sets"), "a map of names, each a selection")) {
    input.sets.push_back(read_set(name, key));
  }
}

void read_curves(Section& scene, Input& input) {
  if (!scene.has("curves")) return;
  for (const auto& [name, key] : entries(scene.at("curves"), "a map of names, each a list of points [time, value]")) {
    input.curves[name] = read_curve(key);
  }
}

}  // namespace brunt::scene
