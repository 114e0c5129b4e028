// SPDX-License-Identifier: Apache-2.0
// The tip of a cylinder or a tube.
#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "given_body.hpp"

namespace brunt::scene {
namespace {

using Shape = mesh::Nose::Shape;

const Choices<Shape> shapes{
    {{"blunt", Shape::none}, {"hemisphere", Shape::hemisphere}, {"cone", Shape::cone}, {"ogive", Shape::ogive}}, {}};
constexpr Range acute{0, 90, false, false, "an angle > 0 and < 90 degrees"};
constexpr Range at_least_half{0.5, infinity, true, false, "a number >= 0.5"};

std::string_view shape_of(const GivenNose& nose) {
  for (const auto& [word, shape] : shapes.now)
    if (nose.shape == shape) return word;
  return "";
}

void judge_nose(const Key& map, GivenNose& nose) {
  constexpr std::string_view expected = "one of length and half_angle";
  if (nose.shape == Shape::cone && has(map, "length") && has(map, "half_angle"))
    fault(at(map, "half_angle"), fmt::format("invalid together with length; expected {}", expected));
  if (nose.shape == Shape::cone && !has(map, "length") && !has(map, "half_angle"))
    lacking(map, {"length", "half_angle"}, fmt::format("missing length of the cone; expected {}", expected));
  if (!has(map, "tip_radius")) refuse_any(map, {"elements"}, "invalid without tip_radius; expected no such key");
}

/// A chamfered blunt end is a short cone of 45 degrees.
mesh::Nose chamfered(const Key& map, double chamfer, double radius) {
  if (chamfer < radius) return {.shape = Shape::cone, .length = chamfer, .tip_radius = radius - chamfer};
  fault(at(map, "chamfer"),
        fmt::format("out of range: {} is not below the radius {}; expected a smaller number", chamfer, radius));
  return {};
}

/// Radius of a flat tip; 0 without one, or with a fault.
double tip_of(const Key& map, const GivenNose& given, double radius, double inner) {
  const double tip = given.tip_radius.value_or(0);
  if (!given.tip_radius || (tip > inner && tip < radius)) return tip;
  fault(at(map, "tip_radius"), fmt::format("out of range: {}; expected a number > {} and < {}", tip, inner, radius));
  return 0;
}

/// The length of a cone follows from its half angle, which is measured from the axis to its side.
double length_of(const GivenNose& given, double radius, double tip_radius) {
  if (given.length) return *given.length;
  return (radius - tip_radius) / std::tan(given.half_angle.value_or(45) * std::numbers::pi / 180);
}

}  // namespace

const Table<GivenNose> nose_keys{
    "mesh.BODY.nose",
    "a map {shape: blunt, hemisphere, cone or ogive, ...}",
    {
        {"shape", value(&GivenNose::shape, shapes), "-", "Shape of the nose.", required},
        {"half_angle", of("cone"), value(&GivenNose::half_angle, acute), "degree", "Angle between axis and side.",
         "required, or `length`"},
        {"length", of("cone"), value(&GivenNose::length, positive), "length", "From shoulder to tip.",
         "required, or `half_angle`"},
        {"crh", of("ogive"), value(&GivenNose::crh, at_least_half), "-", "Radius of its arc over the diameter.",
         required},
        {"chamfer", of("blunt"), value(&GivenNose::chamfer, positive), "length",
         "Width of an edge that is cut at 45 degrees, below the radius."},
        {"tip_radius", of("cone", "ogive"), value(&GivenNose::tip_radius, positive), "length",
         "Radius of a flat tip, below the radius of the body."},
        {"elements", of("cone", "ogive"), value(&GivenNose::elements, at_least_one), "-",
         "With `tip_radius`: elements along the nose.", "as across the radius"},
    },
    judge_nose,
    shape_of,
};

mesh::Nose nose_of(const Key& map_of_body, const GivenBody& body, double radius, double inner, int through) {
  if (!body.nose || radius <= inner) return {};
  const GivenNose& given = *body.nose;
  const Key map = at(map_of_body, "nose");
  mesh::Nose form{.shape = given.shape.value_or(Shape::none)};
  if (form.shape == Shape::none) return given.chamfer ? chamfered(map, *given.chamfer, radius) : form;
  if (form.shape != Shape::hemisphere) form.tip_radius = tip_of(map, given, radius, inner);
  if (form.shape == Shape::cone) form.length = length_of(given, radius, form.tip_radius);
  form.crh = given.crh.value_or(0);
  if (form.tip_radius > 0)
    form.elements = given.elements.value_or(0);
  else if (through < 2)
    fault(at(map_of_body, "elements"),
          fmt::format("out of range: {} element through the wall is too few for a pointed nose; expected at least 2",
                      through));
  return form;
}

}  // namespace brunt::scene
