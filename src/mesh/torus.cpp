// SPDX-License-Identifier: Apache-2.0
// Hollow tori.
#include <fmt/core.h>

#include <cmath>

#include "hex_body.hpp"
#include "mesh/primitives.hpp"
#include "section.hpp"

namespace brunt::mesh {
namespace {

/// Directions around, as cosine and sine, at equal angles from (1, 0).
std::vector<std::array<double, 2>> directions(int around) {
  bool closed = true;
  return ray_directions(around, {}, closed);
}

/// Nodes and cells around the ring, around the tube, through the wall; the last runs fastest.
struct TorusGrid {
  LocalIndex ring, tube, wall;  ///< elements

  [[nodiscard]] LocalIndex node(LocalIndex i, LocalIndex j, LocalIndex k) const {
    return (i % ring * tube + j % tube) * (wall + 1) + k;
  }
  [[nodiscard]] LocalIndex layer(LocalIndex node) const { return node % (wall + 1); }
};

std::vector<Vec3> nodes_of(const TorusGrid& grid, double radius, const std::vector<double>& wall) {
  std::vector<Vec3> nodes;
  nodes.reserve(static_cast<std::size_t>(grid.ring) * static_cast<std::size_t>(grid.tube) * wall.size());
  const auto around_tube = directions(grid.tube);
  for (const auto& [cos_u, sin_u] : directions(grid.ring))
    for (const auto& [cos_w, sin_w] : around_tube)
      for (const double r : wall) {
        const double off_axis = radius + r * cos_w;
        nodes.emplace_back(off_axis * cos_u, off_axis * sin_u, r * sin_w);
      }
  return nodes;
}

std::vector<LocalIndex> cells_of(const TorusGrid& grid) {
  std::vector<LocalIndex> cells;
  cells.reserve(static_cast<std::size_t>(nodes_per_element(Shape::hex8)) * static_cast<std::size_t>(grid.ring) *
                static_cast<std::size_t>(grid.tube) * static_cast<std::size_t>(grid.wall));
  for (LocalIndex i = 0; i < grid.ring; ++i)
    for (LocalIndex j = 0; j < grid.tube; ++j)
      for (LocalIndex k = 0; k < grid.wall; ++k)
        for (const LocalIndex layer : {k, k + 1})
          for (const LocalIndex corner : {grid.node(i, j, layer), grid.node(i + 1, j, layer),
                                          grid.node(i + 1, j + 1, layer), grid.node(i, j + 1, layer)})
            cells.push_back(corner);
  return cells;
}

}  // namespace

Mesh torus(const std::string& part, double radius, double inner_radius, double outer_radius,
           const Divisions<3>& elements) {
  ParameterCheck check("torus " + part);
  check.positive("inner radius of the tube", inner_radius);
  check.holds(inner_radius < outer_radius,
              fmt::format("out of range: the inner radius {} of the tube; expected less than its outer radius {}",
                          inner_radius, outer_radius));
  check.holds(std::isfinite(radius) && radius > outer_radius,
              fmt::format("out of range: radius is {}; expected more than the outer radius {} of the tube", radius,
                          outer_radius));
  check.at_least("elements around the ring", elements[0], 3);
  check.at_least("elements around the tube", elements[1], 3);
  check.holds(elements[0].is_even() && elements[1].is_even(),
              "invalid sizes of elements around; expected equal elements");
  check.divided("elements through the wall", elements[2], 1);
  check.fits(1.0 * elements[0] * elements[1] * (elements[2] + 1.0));
  check.finish();
  const TorusGrid grid{elements[0], elements[1], elements[2]};
  Mesh mesh = hex_body(part, {nodes_of(grid, radius, places(elements[2], inner_radius, outer_radius)), cells_of(grid)});
  add_surface_sets(mesh, {{part + "_side", [&grid](LocalIndex n) { return grid.layer(n) == grid.wall; }},
                          {part + "_inner", [&grid](LocalIndex n) { return grid.layer(n) == 0; }}});
  return mesh;
}

}  // namespace brunt::mesh
