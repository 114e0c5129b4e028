// SPDX-License-Identifier: Apache-2.0
// A rounded cube of cells within shells that grow from its six faces.
#include "ball.hpp"

#include <algorithm>

#include "mesh/primitives.hpp"
#include "mesh/topology.hpp"

namespace brunt::mesh {
namespace {

struct Core {
  Mesh mesh;
  std::vector<std::array<int, 3>> cell;  // of each node, from -k to k
};

Core core_cells(const RoundedCore& shape) {
  const int k = shape.half_cells(), cells = 2 * k, row = cells + 1;
  Core core{box("core", Vec3::Ones(), {cells, cells, cells}), {}};
  for (LocalIndex n = 0; n < static_cast<LocalIndex>(core.mesh.coordinates.size()); ++n) {
    const auto& cell = core.cell.emplace_back(std::array<int, 3>{n % row - k, n / row % row - k, n / (row * row) - k});
    nth(core.mesh.coordinates, n) = shape.inside(cell);
  }
  return core;
}

/// The elements all of whose nodes are on the sides that are kept; of those all nodes they use.
/// `kept[node]`: its new number, or none.
std::vector<LocalIndex> cut(std::vector<Vec3>& coordinates, std::vector<LocalIndex>& nodes, const Half& half) {
  const auto inside = [&](LocalIndex n) {
    const Vec3& x = nth(coordinates, n);
    return half[0] * x[0] >= 0 && half[1] * x[1] >= 0 && half[2] * x[2] >= 0;
  };
  std::vector<LocalIndex> kept(coordinates.size(), no_index), left;
  for (auto element = nodes.begin(); element != nodes.end(); element += 8)
    if (std::all_of(element, element + 8, inside)) left.insert(left.end(), element, element + 8);
  for (const LocalIndex n : left) nth(kept, n) = 0;
  std::vector<Vec3> of_kept;
  for (std::size_t n = 0; n < kept.size(); ++n) {
    if (kept[n] == no_index) continue;
    kept[n] = static_cast<LocalIndex>(of_kept.size());
    of_kept.push_back(coordinates[n]);
  }
  for (LocalIndex& n : left) n = nth(kept, n);
  coordinates = std::move(of_kept);
  nodes = std::move(left);
  return kept;
}

}  // namespace

Ball ball(const RoundedCore& shape, const Half& half) {
  const Core core = core_cells(shape);
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
  for (int shell = 1; shell <= shape.shells(); ++shell) {
    std::vector<LocalIndex> above(below.size(), no_index);
    for (const LocalIndex n : surface) {
      nth(above, n) = static_cast<LocalIndex>(coordinates.size());
      coordinates.push_back(shape.outside(nth(core.cell, n), shell));
    }
    for (const Side& side : skin)
      for (const auto* level : {&below, &above})
        for (const LocalIndex n : face(side)) nodes.push_back(nth((*level), n));
    below = std::move(above);
  }
  const std::size_t first_outer = coordinates.size() - surface.size();
  const std::vector<LocalIndex> kept = cut(coordinates, nodes, half);
  const auto inner =
      static_cast<LocalIndex>(std::count_if(kept.begin(), kept.begin() + static_cast<std::ptrdiff_t>(first_outer),
                                            [](LocalIndex n) { return n != no_index; }));
  return {{std::move(coordinates), std::move(nodes)}, inner};
}

}  // namespace brunt::mesh
