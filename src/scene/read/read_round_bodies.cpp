// SPDX-License-Identifier: Apache-2.0
// Cylinders, spheres and tubes: halves, quarters and sectors, and noses.
#include <fmt/format.h>

#include <cmath>
#include <cstdlib>
#include <numbers>

#include "read_bodies.hpp"

namespace brunt::scene {
namespace {

/// The axis, from 1, with the sign of the side that is kept.
const Choices<int> sides_of_section{{{"x", 1}, {"-x", -1}, {"y", 2}, {"-y", -2}}, {}};
const Choices<int> sides{{{"x", 1}, {"-x", -1}, {"y", 2}, {"-y", -2}, {"z", 3}, {"-z", -3}}, {}};

constexpr double widest_element =
    30;  ///< [degrees] in a sector: its area is then 5 % less than that of the exact sector

/// `half`, a list of sides that are kept, at most one of an axis; `quarter` is the same with two of them.
void read_half(Section& body, std::array<int, 3>& half, const Choices<int>& choices) {
  const bool quarter = body.has("quarter");
  if (body.has("half") && quarter)
    return fault(body.at("quarter"), "invalid together with half; expected one of them, such as quarter: [x, y]");
  if (!body.has("half") && !quarter) return;
  std::string words;
  for (const auto& choice : choices.now) words += (words.empty() ? "" : ", ") + choice.first;
  const std::string expected = fmt::format("a list of {}{}", quarter ? "two of " : "", words);
  const Key key = body.at(quarter ? "quarter" : "half");
  const std::vector<Key> named = items(key, expected, quarter ? 2 : 0);
  if (named.empty() && key.tree->kind == Tree::Kind::list && key.tree->children.empty() && !quarter)
    wrong(key, expected);
  for (const Key& one : named) {
    int side = 0;
    if (!read(one, side, choices)) continue;
    int& kept = half[static_cast<std::size_t>(std::abs(side) - 1)];
    if (kept != 0)
      fault(one, fmt::format("invalid side '{}': axis {} is named twice; expected each axis once", one.tree->text,
                             "xyz"[std::abs(side) - 1]));
    kept = side > 0 ? 1 : -1;
  }
}

/// `sector: [from, to]`.
void read_sector(Section& body, mesh::RoundForm& form) {
  if (!body.has("sector")) return;
  constexpr std::string_view expected = "two angles in degrees [from, to], less than 360 apart";
  const Key key = body.at("sector");
  for (const char* other : {"half", "quarter"})
    if (body.has(other)) return fault(key, fmt::format("invalid together with {}; expected one of them", other));
  std::array<double, 2> angles{};
  if (!read(key, angles, any_number, expected)) return;
  const auto& [from, to] = angles;
  if (!(to > from && to - from < 360 && std::abs(from) <= 360))
    return fault(key, fmt::format("out of range: a sector from {} to {}; expected {}, the first from -360 to 360", from,
                                  to, expected));
  form.sector = {from, to};
}

/// The length of a cone follows from its half angle, which is measured from the axis to its side.
void read_cone(Section& nose, mesh::Nose& form, double radius) {
  const bool by_length = nose.has("length"), by_angle = nose.has("half_angle");
  constexpr std::string_view expected = "one of length and half_angle";
  if (by_length && by_angle)
    return fault(nose.at("half_angle"), fmt::format("invalid together with length; expected {}", expected));
  if (by_length) {
    nose.required("length", form.length, positive);
  } else if (by_angle) {
    double angle = 45;
    nose.required("half_angle", angle, Range{0, 90, false, false, "an angle > 0 and < 90 degrees"});
    form.length = (radius - form.tip_radius) / std::tan(angle * std::numbers::pi / 180);
  } else {
    lacking(nose.key(), {"length", "half_angle"}, fmt::format("missing length of the cone; expected {}", expected));
  }
}

/// A chamfered blunt end is a short cone of 45 degrees.
void read_chamfer(Section& nose, mesh::Nose& form, double radius) {
  double chamfer = 0;
  if (!nose.optional("chamfer", chamfer, positive)) return;
  if (chamfer >= radius)
    return fault(
        nose.at("chamfer"),
        fmt::format("out of range: {} is not below the radius {}; expected a smaller number", chamfer, radius));
  form = {.shape = mesh::Nose::Shape::cone, .length = chamfer, .tip_radius = radius - chamfer};
}

void read_flat_tip(Section& nose, mesh::Nose& form, double radius, double inner) {
  if (!nose.optional("tip_radius", form.tip_radius, positive)) return;
  if (form.tip_radius > inner && form.tip_radius < radius) return;
  fault(nose.at("tip_radius"),
        fmt::format("out of range: {}; expected a number > {} and < {}", form.tip_radius, inner, radius));
  form.tip_radius = 0;
}

void read_nose(Section& body, mesh::Nose& form, double radius, double inner, int through) {
  if (!body.has("nose")) return;
  using Shape = mesh::Nose::Shape;
  Section nose(body.at("nose"), "a map {shape: blunt, hemisphere, cone or ogive, ...}");
  if (!nose.is_map() || radius <= inner) return;
  if (!nose.required("shape", form.shape,
                     Choices<Shape>{{{"blunt", Shape::none},
                                     {"hemisphere", Shape::hemisphere},
                                     {"cone", Shape::cone},
                                     {"ogive", Shape::ogive}},
                                    {}}))
    return;
  if (form.shape == Shape::none)
    read_chamfer(nose, form, radius);
  else if (form.shape != Shape::hemisphere)
    read_flat_tip(nose, form, radius, inner);
  if (form.shape == Shape::cone && form.length == 0) read_cone(nose, form, radius);
  if (form.shape == Shape::ogive)
    nose.required("crh", form.crh,
                  Range{0.5, infinity, true, false, "a number >= 0.5, the radius of the arc divided by the diameter"});
  if (form.tip_radius > 0)
    nose.optional("elements", form.elements, at_least_one);
  else if (form.shape != Shape::none && through < 2)
    fault(body.at("elements"),
          fmt::format("out of range: {} element through the wall is too few for a pointed nose; expected at least 2",
                      through));
}

void check_around(Section& body, const TubeMesh& tube) {
  const int around = tube.elements[1];
  const auto& [half, sector, nose] = tube.half;
  if (sector.cuts()) {
    const int least = static_cast<int>(std::ceil((sector.to - sector.from) / widest_element));
    if (around < least)
      fault(body.at("elements"),
            fmt::format("out of range: {} elements around span {:g} degrees each; expected at least {} around", around,
                        (sector.to - sector.from) / around, least));
    return;
  }
  if (around < 3) {
    fault(body.at("elements"),
          fmt::format("out of range: {} elements around do not close a circle; expected at least 3", around));
    return;
  }
  const int parts = (half[0] != 0 ? 2 : 1) * (half[1] != 0 ? 2 : 1);
  if (around % parts != 0)
    fault(body.at("elements"),
          fmt::format(
              "invalid number of elements around: {} cannot be divided into {} equal parts; expected a multiple of {}",
              around, parts, parts));
}

}  // namespace

CylinderMesh read_cylinder(Section& body) {
  CylinderMesh cylinder{.part = {}, .elements = {1, 1}, .half = {}};
  body.required("part", cylinder.part, part_name);
  body.required("radius", cylinder.radius, positive);
  body.required("length", cylinder.length, positive);
  const std::array<Extent, 2> extents{
      {{0, cylinder.radius, "across the radius"}, {0, cylinder.length, "along the axis"}}};
  read_divisions(body, extents, cylinder.elements, "two integers >= 1 [across the radius, along the axis]");
  read_half(body, cylinder.half.half, sides_of_section);
  if (body.has("sector"))
    fault(body.at("sector"),
          "invalid for a cylinder, which has half and quarter; expected a tube with inner_radius: 0 for a sector");
  read_nose(body, cylinder.half.nose, cylinder.radius, 0, 2);
  const double across = cylinder.elements[0], along = cylinder.elements[1];
  demand_countable(body, 4 * (across + 1) * (across + 1) * (along + 1), 4 * across * across * along);
  return cylinder;
}

SphereMesh read_sphere(Section& body) {
  SphereMesh sphere{.part = {}, .elements = 1};
  body.required("part", sphere.part, part_name);
  body.required("radius", sphere.radius, positive);
  body.required("elements", sphere.elements, at_least_one);
  body.optional("finer", sphere.finer, Range{1, infinity, true, false, "a number >= 1"});
  read_half(body, sphere.half, sides);
  if (sphere.finer > 1 && sphere.half[2] > 0)
    fault(body.at(body.has("half") ? "half" : "quarter"),
          "invalid side z with finer: this half keeps the pole that is not refined; expected -z, or no half along z");
  const double across = sphere.elements;
  demand_countable(body, 8 * (across + 1) * (across + 1) * (across + 1), 8 * across * across * across);
  return sphere;
}

TubeMesh read_tube(Section& body) {
  TubeMesh tube{.part = {}, .elements = {1, 3, 1}, .half = {}};
  body.required("part", tube.part, part_name);
  read_sector(body, tube.half);
  const bool sector = body.has("sector");  // an invalid one has been reported
  const bool inner = body.required("inner_radius", tube.inner_radius, sector ? not_negative : positive);
  const bool outer = body.required("outer_radius", tube.outer_radius, positive);
  if (inner && outer && tube.outer_radius <= tube.inner_radius) {
    fault(body.at("outer_radius"),
          fmt::format("out of range: {} is not larger than inner_radius {}; expected a larger number",
                      tube.outer_radius, tube.inner_radius));
  }
  body.required("length", tube.length, positive);
  const std::array<Extent, 3> extents{{{tube.inner_radius, inner && outer ? tube.outer_radius : 0, "through the wall"},
                                       {0, 0, "around", true},
                                       {0, tube.length, "along the axis"}}};
  read_divisions(body, extents, tube.elements, "three integers >= 1 [through the wall, around, along]");
  read_half(body, tube.half.half, sides_of_section);
  check_around(body, tube);
  read_nose(body, tube.half.nose, inner && outer ? tube.outer_radius : 0, tube.inner_radius, tube.elements[0]);
  const double through = tube.elements[0], around = tube.elements[1], along = tube.elements[2];
  demand_countable(body, (through + 1) * around * (along + 1), through * around * along);
  return tube;
}

TorusMesh read_torus(Section& body) {
  TorusMesh torus{.part = {}, .tube = {}, .elements = {3, 3, 1}};
  auto& [inner, outer] = torus.tube;
  body.required("part", torus.part, part_name);
  const bool radius = body.required("radius", torus.radius, positive);
  const bool tube = body.required("tube", torus.tube, positive, "two lengths > 0 [inner radius, outer radius]");
  if (tube && outer <= inner)
    fault(body.at("tube"),
          fmt::format(
              "out of range: the outer radius {} is not larger than the inner radius {}; expected a larger number",
              outer, inner));
  if (radius && tube && torus.radius <= outer)
    fault(body.at("radius"),
          fmt::format(
              "out of range: a ring of radius {} has no hole with a tube of outer radius {}; expected a number > {}",
              torus.radius, outer, outer));
  const std::array<Extent, 3> extents{{{0, 0, "around the ring", true},
                                       {0, 0, "around the tube", true},
                                       {inner, tube ? outer : 0, "through the wall"}}};
  read_divisions(body, extents, torus.elements,
                 "three integers >= 1 [around the ring, around the tube, through the wall]");
  for (const std::size_t i : {0, 1})
    if (torus.elements[i] < 3)
      fault(body.at("elements"), fmt::format("out of range: {} elements {} do not close a circle; expected at least 3",
                                             torus.elements[i].cells, extents[i].what));
  const double ring = torus.elements[0], around = torus.elements[1], through = torus.elements[2];
  demand_countable(body, ring * around * (through + 1), ring * around * through);
  return torus;
}

}  // namespace brunt::scene
