// SPDX-License-Identifier: Apache-2.0
// Boxes, plates, cylinders and tubes: sections extruded along z.
#include "brunt/mesh/primitives.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "hex_body.hpp"
#include "rounded_core.hpp"

namespace brunt::mesh {
namespace {

struct Placed {
  double low = 0, size = 0;
  int cells = 0;
  [[nodiscard]] double at(int i) const { return low + size * i / cells; }
};

Section rectangle(const Placed& x, const Placed& y) {
  Section section;
  for (int j = 0; j <= y.cells; ++j)
    for (int i = 0; i <= x.cells; ++i) section.points.push_back({x.at(i), y.at(j)});
  const int row = x.cells + 1;
  for (int j = 0; j < y.cells; ++j)
    for (int i = 0; i < x.cells; ++i) {
      const LocalIndex corner = i + row * j;
      section.quads.push_back({corner, corner + 1, corner + 1 + row, corner + row});
    }
  return section;
}

Mesh block_of_cells(const std::string& part, const Placed& x, const Placed& y, double height, int layers) {
  Mesh mesh = extrude(part, rectangle(x, y), height, layers);
  const int nx = x.cells, ny = y.cells;
  const auto i = [nx](LocalIndex n) { return n % (nx + 1); };
  const auto j = [nx, ny](LocalIndex n) { return n / (nx + 1) % (ny + 1); };
  const auto k = [nx, ny](LocalIndex n) { return n / ((nx + 1) * (ny + 1)); };
  add_surface_sets(mesh, {{part + "_xmin", [=](LocalIndex n) { return i(n) == 0; }},
                          {part + "_xmax", [=](LocalIndex n) { return i(n) == nx; }},
                          {part + "_ymin", [=](LocalIndex n) { return j(n) == 0; }},
                          {part + "_ymax", [=](LocalIndex n) { return j(n) == ny; }},
                          {part + "_zmin", [=](LocalIndex n) { return k(n) == 0; }},
                          {part + "_zmax", [=](LocalIndex n) { return k(n) == layers; }}});
  return mesh;
}

/// Corners of a square's outline of half width k, counter-clockwise from (-k, -k), 8 k of them.
std::vector<std::array<int, 2>> outline(int k) {
  std::vector<std::array<int, 2>> corners;
  for (int i = -k; i < k; ++i) corners.push_back({i, -k});
  for (int j = -k; j < k; ++j) corners.push_back({k, j});
  for (int i = k; i > -k; --i) corners.push_back({i, k});
  for (int j = k; j > -k; --j) corners.push_back({-k, j});
  return corners;
}

/// Core cells in rows, then rings from the core outwards.
Section butterfly(double radius, int n) {
  const RoundedCore core(radius, n);
  const int k = core.half_cells(), rings = n - k, row = 2 * k + 1;
  Section section = rectangle({0, 1, 2 * k}, {0, 1, 2 * k});
  for (int j = -k; j <= k; ++j)
    for (int i = -k; i <= k; ++i) {
      const Vec3 x = core.inside({i, j, 0});
      const int point = i + k + row * (j + k);
      section.points[static_cast<std::size_t>(point)] = {x[0], x[1]};
    }
  const auto corners = outline(k);
  const auto around = static_cast<LocalIndex>(corners.size());
  const auto node = [&](int ring, LocalIndex c) {
    const auto& [i, j] = corners[static_cast<std::size_t>(c % around)];
    return ring == 0 ? i + k + row * (j + k) : row * row + (ring - 1) * around + c % around;
  };
  for (int ring = 1; ring <= rings; ++ring)
    for (const auto& [i, j] : corners) {
      const Vec3 x = core.outside({i, j, 0}, ring);
      section.points.push_back({x[0], x[1]});
    }
  for (int ring = 0; ring < rings; ++ring)
    for (LocalIndex c = 0; c < around; ++c)
      section.quads.push_back({node(ring, c), node(ring + 1, c), node(ring + 1, c + 1), node(ring, c + 1)});
  return section;
}

/// The part of a circle that is kept, in quarters of it counter-clockwise from the x axis.
struct Arc {
  int first = 0, quarters = 4;
};

Arc arc_of(const Half& half) {
  if (half[0] != 0 && half[1] != 0) return {half[0] > 0 ? (half[1] > 0 ? 0 : 3) : (half[1] > 0 ? 1 : 2), 1};
  if (half[0] != 0) return {half[0] > 0 ? 3 : 1, 2};
  if (half[1] != 0) return {half[1] > 0 ? 0 : 2, 2};
  return {};
}

/// Cosine and sine of `steps` of which `quarter` make 90 degrees: exact on the axes, mirrored exactly between them.
std::array<double, 2> on_circle(int steps, int quarter) {
  const int turns = steps / quarter % 4, rest = steps % quarter;
  const auto angle = [&](int n) { return std::numbers::pi / 2 * n / quarter; };
  double c = std::cos(angle(rest)), s = std::sin(angle(rest));
  if (2 * rest == quarter) c = s = std::numbers::sqrt2 / 2;
  if (2 * rest > quarter) {
    c = std::sin(angle(quarter - rest));
    s = std::cos(angle(quarter - rest));
  }
  if (turns == 0) return {c, s};
  if (turns == 1) return {-s, c};
  return turns == 2 ? std::array{-c, -s} : std::array{s, -c};
}

/// `around` elements make the whole circle.
Section annulus(double inner, double outer, int through, int around, const Arc& arc) {
  const bool closed = arc.quarters == 4;
  const int cells = around * arc.quarters / 4, places = closed ? cells : cells + 1;
  Section section;
  for (int c = 0; c < places; ++c) {
    const auto [cosine, sine] = on_circle(arc.first * around + 4 * c, around);
    for (int r = 0; r <= through; ++r) {
      const double radius = inner + (outer - inner) * r / through;
      section.points.push_back({radius * cosine, radius * sine});
    }
  }
  const int row = through + 1;
  for (int c = 0; c < cells; ++c)
    for (int r = 0; r < through; ++r) {
      const LocalIndex here = c * row + r, there = (c + 1) % places * row + r;
      section.quads.push_back({here, here + 1, there + 1, there});
    }
  return section;
}

/// The cells on the sides that are kept, with their points in the same order; `tag` of each point stays with it.
void keep_half(Section& section, std::vector<char>& tag, const Half& half) {
  const auto inside = [&](LocalIndex n) {
    const auto& x = section.points[static_cast<std::size_t>(n)];
    return half[0] * x[0] >= 0 && half[1] * x[1] >= 0;
  };
  std::erase_if(section.quads, [&](const auto& quad) { return !std::ranges::all_of(quad, inside); });
  std::vector<LocalIndex> place(section.points.size(), no_index);
  for (const auto& quad : section.quads)
    for (const LocalIndex n : quad) place[static_cast<std::size_t>(n)] = 0;
  Section kept;
  std::vector<char> tag_of_kept;
  for (std::size_t n = 0; n < place.size(); ++n) {
    if (place[n] == no_index) continue;
    place[n] = static_cast<LocalIndex>(kept.points.size());
    kept.points.push_back(section.points[n]);
    tag_of_kept.push_back(tag[n]);
  }
  for (auto& quad : section.quads)
    for (LocalIndex& n : quad) n = place[static_cast<std::size_t>(n)];
  section.points = std::move(kept.points);
  tag = std::move(tag_of_kept);
}

void check_half(ParameterCheck& check, const Half& half) {
  check.holds(half[2] == 0, "half along its axis is one of half the length; accepted: x, y");
}

}  // namespace

Mesh box(const std::string& part, const Vec3& size, const std::array<int, 3>& elements) {
  ParameterCheck check("box " + part);
  for (int i = 0; i < 3; ++i) {
    check.positive("size", size[i]);
    check.at_least("elements", elements[static_cast<std::size_t>(i)], 1);
  }
  check.fits((elements[0] + 1.0) * (elements[1] + 1.0) * (elements[2] + 1.0));
  check.finish();
  return block_of_cells(part, {0, size[0], elements[0]}, {0, size[1], elements[1]}, size[2], elements[2]);
}

Mesh plate(const std::string& part, const std::array<double, 2>& size, double thickness,
           const std::array<int, 3>& elements) {
  ParameterCheck check("plate " + part);
  for (const double s : size) check.positive("size", s);
  check.positive("thickness", thickness);
  for (const int n : elements) check.at_least("elements", n, 1);
  check.fits((elements[0] + 1.0) * (elements[1] + 1.0) * (elements[2] + 1.0));
  check.finish();
  return block_of_cells(part, {-size[0] / 2, size[0], elements[0]}, {-size[1] / 2, size[1], elements[1]}, thickness,
                        elements[2]);
}

int elements_around(int across_radius) {
  return 8 * RoundedCore(1.0, across_radius).half_cells();
}

Mesh cylinder(const std::string& part, double radius, double length, const std::array<int, 2>& elements,
              const Half& half) {
  ParameterCheck check("cylinder " + part);
  check.positive("radius", radius);
  check.positive("length", length);
  check.at_least("elements across the radius", elements[0], 2);
  check.at_least("elements along the axis", elements[1], 1);
  check.fits(4.0 * elements[0] * elements[0] * (elements[1] + 1.0));
  check_half(check, half);
  check.finish();
  Section section = butterfly(radius, elements[0]);
  std::vector<char> outer(section.points.size(), 0);
  std::fill(outer.end() - elements_around(elements[0]), outer.end(), 1);
  keep_half(section, outer, half);
  Mesh mesh = extrude(part, section, length, elements[1]);
  const auto layer = static_cast<LocalIndex>(section.points.size());
  const LocalIndex top = layer * elements[1];
  std::vector<SurfaceSet> sets{
      {part + "_bottom", [=](LocalIndex n) { return n < layer; }},
      {part + "_top", [=](LocalIndex n) { return n >= top; }},
      {part + "_side", [=](LocalIndex n) { return outer[static_cast<std::size_t>(n % layer)] != 0; }}};
  add_cut_planes(mesh, part, half, sets);
  add_surface_sets(mesh, sets);
  return mesh;
}

Mesh tube(const std::string& part, double inner_radius, double outer_radius, double length,
          const std::array<int, 3>& elements, const Half& half) {
  const Arc arc = arc_of(half);
  ParameterCheck check("tube " + part);
  check.positive("inner_radius", inner_radius);
  check.positive("outer_radius", outer_radius);
  check.holds(inner_radius < outer_radius,
              fmt::format("inner_radius {} must be below outer_radius {}", inner_radius, outer_radius));
  check.positive("length", length);
  check.at_least("elements through the wall", elements[0], 1);
  check.at_least("elements around", elements[1], 3);
  check.at_least("elements along the axis", elements[2], 1);
  check.fits((elements[0] + 1.0) * elements[1] * (elements[2] + 1.0));
  check_half(check, half);
  check.holds(elements[1] * arc.quarters % 4 == 0,
              fmt::format("{} elements around the whole cannot be cut into {} equal parts; accepted: a multiple of {}",
                          elements[1], 4 / arc.quarters, 4 / arc.quarters));
  check.finish();
  const Section section = annulus(inner_radius, outer_radius, elements[0], elements[1], arc);
  Mesh mesh = extrude(part, section, length, elements[2]);
  const LocalIndex row = elements[0] + 1, layer = static_cast<LocalIndex>(section.points.size()),
                   top = layer * elements[2];
  std::vector<SurfaceSet> sets{{part + "_bottom", [=](LocalIndex n) { return n < layer; }},
                               {part + "_top", [=](LocalIndex n) { return n >= top; }},
                               {part + "_side", [=](LocalIndex n) { return n % row == row - 1; }},
                               {part + "_inner", [=](LocalIndex n) { return n % row == 0; }}};
  add_cut_planes(mesh, part, half, sets);
  add_surface_sets(mesh, sets);
  return mesh;
}

}  // namespace brunt::mesh
