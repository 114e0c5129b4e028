// SPDX-License-Identifier: Apache-2.0
// A solid sphere: a rounded cube of cells within shells that grow from its six faces.
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

}  // namespace

Mesh sphere(const std::string& part, double radius, int elements) {
  ParameterCheck check("sphere " + part);
  check.positive("radius", radius);
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
  const auto first_outer = static_cast<LocalIndex>(coordinates.size() - surface.size());
  Mesh mesh = hex_body(part, std::move(coordinates), std::move(nodes));
  add_surface_sets(mesh, {{part + "_surface", [=](LocalIndex n) { return n >= first_outer; }}});
  return mesh;
}

}  // namespace brunt::mesh
