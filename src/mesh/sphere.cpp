// SPDX-License-Identifier: Apache-2.0
// A solid sphere: a rounded cube of cells within shells that grow from its six faces.
#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "brunt/mesh/primitives.hpp"
#include "brunt/mesh/topology.hpp"
#include "hex_body.hpp"
#include "rounded_core.hpp"

namespace brunt::mesh {
namespace {

struct Core {
  Mesh mesh;
  std::vector<std::array<int, 3>> cell;  // of each node, from -k to k
};

Core core_cells(const std::string& part, const RoundedCore& shape) {
  const int k = shape.half_cells(), cells = 2 * k, row = cells + 1;
  Core core{box(part, Vec3::Ones(), {cells, cells, cells}), {}};
  for (LocalIndex n = 0; n < static_cast<LocalIndex>(core.mesh.coordinates.size()); ++n) {
    const auto& cell = core.cell.emplace_back(std::array<int, 3>{n % row - k, n / row % row - k, n / (row * row) - k});
    core.mesh.coordinates[static_cast<std::size_t>(n)] = shape.inside(cell);
  }
  return core;
}

/// The conformal map of the ball of this radius onto itself that shrinks what is at the lowest point by `finer`, and
/// widens as much what is at the highest (a translation of hyperbolic space). Planes x = 0, y = 0 stay.
Vec3 draw_down(const Vec3& x, double radius, double finer) {
  const Vec3 p = x / radius, a(0, 0, -(finer - 1) / (finer + 1));
  const double along = 1 + 2 * a.dot(p), p2 = p.squaredNorm(), a2 = a.squaredNorm();
  return radius * ((along + p2) * a + (1 - a2) * p) / (along + a2 * p2);
}

/// The same within the half ball z <= 0: its plane stays, and elements are smaller by `finer` at the lowest point
/// alone. The map above multiplies the ratio t of a point's distances from lowest and highest point by 1/finer; this
/// one by (1 + (finer - 1) t^2) / finer, which is 1 in the plane, where t = 1. Along a line from pole to plane, lengths
/// are stretched against those across it by d ln t' / d ln t, from 1 at the pole to below 3 in the plane.
Vec3 draw_down_half(const Vec3& x, double radius, double finer) {
  if (x[2] == 0) return x;
  const double p2 = x.squaredNorm() / (radius * radius), z = x[2] / radius;
  const double t2 = (1 + p2 + 2 * z) / (1 + p2 - 2 * z);
  return draw_down(x, radius, finer / (1 + (finer - 1) * t2));
}

/// The elements all of whose nodes are on the sides that are kept; of those all nodes they use.
/// `kept[node]`: its new number, or none.
std::vector<LocalIndex> cut(std::vector<Vec3>& coordinates, std::vector<LocalIndex>& nodes, const Half& half) {
  const auto inside = [&](LocalIndex n) {
    const Vec3& x = coordinates[static_cast<std::size_t>(n)];
    return half[0] * x[0] >= 0 && half[1] * x[1] >= 0 && half[2] * x[2] >= 0;
  };
  std::vector<LocalIndex> kept(coordinates.size(), no_index), left;
  for (auto element = nodes.begin(); element != nodes.end(); element += 8)
    if (std::all_of(element, element + 8, inside)) left.insert(left.end(), element, element + 8);
  for (const LocalIndex n : left) kept[static_cast<std::size_t>(n)] = 0;
  std::vector<Vec3> of_kept;
  for (std::size_t n = 0; n < kept.size(); ++n) {
    if (kept[n] == no_index) continue;
    kept[n] = static_cast<LocalIndex>(of_kept.size());
    of_kept.push_back(coordinates[n]);
  }
  for (LocalIndex& n : left) n = kept[static_cast<std::size_t>(n)];
  coordinates = std::move(of_kept);
  nodes = std::move(left);
  return kept;
}

}  // namespace

Mesh sphere(const std::string& part, double radius, int elements, const SphereForm& form) {
  ParameterCheck check("sphere " + part);
  check.positive("radius", radius);
  check.holds(std::isfinite(form.finer) && form.finer >= 1, fmt::format("finer must be >= 1, got {}", form.finer));
  check.holds(form.finer == 1 || form.half[2] <= 0,
              "half z keeps the pole that finer does not refine; accepted: -z, or no half along z");
  check.at_least("elements across the radius", elements, 2);
  check.fits(24.0 * elements * elements * elements);
  check.finish();

  const RoundedCore shape(radius, elements);
  const Core core = core_cells(part, shape);
  std::vector<Vec3> coordinates = core.mesh.coordinates;
  std::vector<LocalIndex> nodes = core.mesh.blocks[0].nodes;
  const auto skin = exterior_sides(core.mesh);
  const auto face = [&](const Side& s) {
    return face_nodes(Shape::hex8, core.mesh.blocks[0].element(s.element), s.face);
  };

  std::vector<LocalIndex> below(core.cell.size()), surface;  // nodes on the last shell made, by core node
  for (std::size_t n = 0; n < core.cell.size(); ++n) {
    below[n] = static_cast<LocalIndex>(n);
    const auto& [i, j, l] = core.cell[n];
    if (std::max({std::abs(i), std::abs(j), std::abs(l)}) == shape.half_cells())
      surface.push_back(static_cast<LocalIndex>(n));
  }
  for (int shell = 1; shell <= elements - shape.half_cells(); ++shell) {
    std::vector<LocalIndex> above(below.size(), no_index);
    for (const LocalIndex n : surface) {
      above[static_cast<std::size_t>(n)] = static_cast<LocalIndex>(coordinates.size());
      coordinates.push_back(shape.outside(core.cell[static_cast<std::size_t>(n)], shell));
    }
    for (const Side& side : skin)
      for (const auto* level : {&below, &above})
        for (const LocalIndex n : face(side)) nodes.push_back((*level)[static_cast<std::size_t>(n)]);
    below = std::move(above);
  }
  const std::size_t first_outer = coordinates.size() - surface.size();
  const std::vector<LocalIndex> kept = cut(coordinates, nodes, form.half);
  const auto inner =
      static_cast<LocalIndex>(std::count_if(kept.begin(), kept.begin() + static_cast<std::ptrdiff_t>(first_outer),
                                            [](LocalIndex n) { return n != no_index; }));
  std::vector<SurfaceSet> sets{{part + "_surface", [=](LocalIndex n) { return n >= inner; }}};
  Mesh mesh = hex_body(part, std::move(coordinates), std::move(nodes));
  add_cut_planes(mesh, part, form.half, sets);  // before the map, which keeps these planes to rounding
  if (form.finer > 1)
    for (Vec3& x : mesh.coordinates)
      x = form.half[2] != 0 ? draw_down_half(x, radius, form.finer) : draw_down(x, radius, form.finer);
  add_surface_sets(mesh, sets);
  return mesh;
}

}  // namespace brunt::mesh
