// SPDX-License-Identifier: Apache-2.0
// Cylinders and tubes: sections extruded along z, with a nose or without.
#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "mesh/assemble.hpp"
#include "mesh/primitives.hpp"
#include "nose.hpp"

namespace brunt::mesh {
namespace {

void check_form(ParameterCheck& check, const RoundForm& form, double radius, double inner) {
  check.holds(form.half[2] == 0, "invalid half along the axis (take half of the length instead); expected x, y");
  const auto& [from, to] = form.sector;
  check.holds(from == 0 && to == 0 ? true : to > from && to - from < 360,
              fmt::format("out of range: the sector from {} to {} degrees; expected an angle > 0 and < 360", from, to));
  check.holds(!form.sector.cuts() || form.half == Half{}, "invalid sector together with half; expected one of them");
  const Nose& nose = form.nose;
  if (nose.shape == Nose::Shape::none) return;
  check.holds(
      nose.tip_radius == 0 || (nose.tip_radius > inner && nose.tip_radius < radius),
      fmt::format("out of range: tip_radius is {}; expected a number > {} and < {}", nose.tip_radius, inner, radius));
  check.holds(nose.shape != Nose::Shape::hemisphere || nose.tip_radius == 0,
              "invalid tip_radius of a hemisphere; expected none");
  if (nose.shape == Nose::Shape::cone) check.positive("length of the nose", nose.length);
  if (nose.shape == Nose::Shape::ogive)
    check.holds(std::isfinite(nose.crh) && nose.crh >= 0.5,
                fmt::format("out of range: crh is {}; expected at least 0.5", nose.crh));
}

/// Elements along a blunt nose that are as long as those across the radius are on average.
int nose_layers(const Nose& nose, const Outline& outline, double size) {
  return nose.elements > 0 ? nose.elements : std::max(1, static_cast<int>(std::lround(outline.length() / size)));
}

RoundBody shank(const Section& section, const std::vector<double>& heights, const std::vector<Marks>& mark) {
  RoundBody body{extrude(section, heights), {}, 0};
  for (std::size_t k = 0; k < heights.size(); ++k)
    for (const Marks one : mark) body.mark.push_back(static_cast<Marks>(one | (k == 0 ? on_bottom : Marks{0})));
  body.end = static_cast<LocalIndex>(section.points.size() * (heights.size() - 1));
  return body;
}

void mark_end(RoundBody& body) {
  for (auto n = static_cast<std::size_t>(body.end); n < body.mark.size(); ++n) body.mark[n] |= on_top;
}

/// Nodes on the first and the last ray are in the planes of the cut, and no others: a sector has at least one element.
void add_sector_planes(const Mesh& mesh, const std::string& part, const Sector& sector, std::vector<SurfaceSet>& sets) {
  for (const bool first : {true, false}) {
    const auto [cosine, sine] = cosine_sine(first ? sector.from : sector.to);
    std::vector<char> in_plane;
    for (const Vec3& x : mesh.coordinates) {
      const double along = cosine * x[0] + sine * x[1], off = cosine * x[1] - sine * x[0];
      in_plane.push_back(std::abs(off) <= 1e-9 * along || (x[0] == 0 && x[1] == 0));
    }
    sets.push_back({part + (first ? "_from" : "_to"), [in_plane](LocalIndex n) { return nth(in_plane, n) != 0; }});
  }
}

Mesh finished(const std::string& part, RoundBody body, const RoundForm& form) {
  const auto mark = std::move(body.mark);
  std::vector<SurfaceSet> sets;
  const auto add = [&](const char* name, Marks bit) {
    if (std::ranges::none_of(mark, [bit](Marks one) { return (one & bit) != 0; })) return;
    sets.push_back({part + name, [&mark, bit](LocalIndex n) { return (nth(mark, n) & bit) != 0; }});
  };
  add("_bottom", on_bottom);
  add("_top", on_top);
  add("_side", on_side);
  add("_inner", on_inner);
  add("_nose", on_nose);
  Mesh mesh = hex_body(part, std::move(body.cells));
  add_cut_planes(mesh, part, form.half, sets);
  if (form.sector.cuts()) add_sector_planes(mesh, part, form.sector, sets);
  add_surface_sets(mesh, sets);
  return mesh;
}

}  // namespace

int elements_around(const Division& across_radius) {
  const double radius = across_radius.sizes.empty() ? 1 : std::max(1.0, across_radius.sizes.back().place);
  return 8 * RoundedCore::half_cells_of(places(across_radius, 0, radius), round_from(across_radius));
}

Mesh cylinder(const std::string& part, double radius, double length, const Divisions<2>& elements,
              const RoundForm& form) {
  ParameterCheck check("cylinder " + part);
  check.positive("radius", radius);
  check.positive("length", length);
  check.divided("elements across the radius", elements[0], 2);
  check.at_least("elements within the first circle", round_from(elements[0]), std::min(2, elements[0].cells));
  check.divided("elements along the axis", elements[1], 1);
  check.fits(4.0 * elements[0] * elements[0] * (elements[1] + 1.0));
  check_form(check, form, radius, 0);
  check.holds(!form.sector.cuts(), "invalid sector of a cylinder; expected a tube with inner_radius 0");
  check.finish();
  const RoundedCore core = rounded_core(radius, elements[0]);
  Section section = butterfly(core);
  std::vector<char> outer(section.points.size(), 0);
  std::fill(outer.end() - 8 * core.half_cells(), outer.end(), 1);
  keep_half(section, outer, form.half);
  RoundBody body = shank(section, places(elements[1], 0, length), std::vector<Marks>(outer.begin(), outer.end()));
  if (form.nose.shape == Nose::Shape::none) {
    mark_end(body);
  } else {
    const Outline outline(form.nose, radius, 0);
    if (form.nose.tip_radius > 0)
      add_blunt_nose(body, section, outline, 0, nose_layers(form.nose, outline, radius / elements[0]));
    else
      add_pointed_nose(body, section, core, form.half, outline);
  }
  return finished(part, std::move(body), form);
}

Mesh tube(const std::string& part, double inner_radius, double outer_radius, double length,
          const Divisions<3>& elements, const RoundForm& form) {
  ParameterCheck check("tube " + part);
  if (!form.sector.cuts() || inner_radius != 0) check.positive("inner_radius", inner_radius);
  check.positive("outer_radius", outer_radius);
  check.holds(
      inner_radius < outer_radius,
      fmt::format("out of range: inner_radius is {}; expected less than outer_radius {}", inner_radius, outer_radius));
  check.positive("length", length);
  check.divided("elements through the wall", elements[0], 1);
  check.at_least("elements around", elements[1], form.sector.cuts() ? 1 : 3);
  check.holds(elements[1].is_even(), "invalid sizes of elements around; expected equal elements");
  check.divided("elements along the axis", elements[2], 1);
  check.fits((elements[0] + 1.0) * elements[1] * (elements[2] + 1.0));
  check_form(check, form, outer_radius, inner_radius);
  const int parts = (form.half[0] != 0 ? 2 : 1) * (form.half[1] != 0 ? 2 : 1);
  check.holds(
      elements[1] % parts == 0,
      fmt::format(
          "invalid number of elements around: {} cannot be divided into {} equal parts; expected a multiple of {}",
          elements[1], parts, parts));
  check.finish();
  Rays rays{places(elements[0], inner_radius, outer_radius), {}, true};
  rays.cosines = ray_directions(elements[1], form, rays.closed);
  const Section section = annulus(rays);
  std::vector<Marks> mark(section.points.size(), 0);
  for (int c = 0; c < static_cast<int>(rays.cosines.size()); ++c) {
    if (!rays.solid()) nth(mark, rays.point(c, 0)) |= on_inner;
    nth(mark, rays.point(c, elements[0])) |= on_side;
  }
  RoundBody body = shank(section, places(elements[2], 0, length), mark);
  if (form.nose.shape == Nose::Shape::none) {
    mark_end(body);
  } else {
    const Outline outline(form.nose, outer_radius, inner_radius);
    const double size = (outer_radius - inner_radius) / elements[0];
    if (form.nose.tip_radius > 0)
      add_blunt_nose(body, section, outline, inner_radius, nose_layers(form.nose, outline, size));
    else
      add_pointed_nose(body, rays, outline);
  }
  return finished(part, std::move(body), form);
}

}  // namespace brunt::mesh
