// SPDX-License-Identifier: Apache-2.0
// Shared steps of the generated bodies.
#include "hex_body.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "core/error.hpp"
#include "mesh/topology.hpp"

namespace brunt::mesh {

void ParameterCheck::positive(const char* name, double value) {
  holds(std::isfinite(value) && value > 0, fmt::format("out of range: {} is {}; expected a number > 0", name, value));
}

void ParameterCheck::at_least(const char* name, int value, int least) {
  holds(value >= least, fmt::format("out of range: {0} is {2}; expected at least {1}", name, least, value));
}

void ParameterCheck::divided(const char* name, const Division& division, int least) {
  at_least(name, division.cells, least);
  holds(std::isfinite(division.bias) && division.bias > 0,
        fmt::format("out of range: bias of {} is {}; expected a number > 0", name, division.bias));
}

void ParameterCheck::holds(bool condition, const std::string& fault) {
  if (!condition) faults_.push_back(fmt::format("{}: {}", body_, fault));
}

void ParameterCheck::fits(double nodes) {
  const double corners = nodes_per_element(Shape::hex8);
  const double most = std::numeric_limits<LocalIndex>::max() / corners;  // of all elements in one array
  holds(nodes <= most, fmt::format("out of range: {:.3g} nodes in one mesh; expected at most {:.3g}", nodes, most));
}

void ParameterCheck::finish() const {
  if (!faults_.empty()) throw InputError(faults_);
}

Mesh hex_body(const std::string& part, Hexahedra cells) {
  Mesh mesh;
  mesh.node_id.resize(cells.coordinates.size());
  std::iota(mesh.node_id.begin(), mesh.node_id.end(), 1);
  mesh.coordinates = std::move(cells.coordinates);
  Block& block = mesh.blocks.emplace_back(Block{part, 1, Shape::hex8, std::move(cells.nodes), {}});
  block.element_id.resize(static_cast<std::size_t>(block.count()));
  std::iota(block.element_id.begin(), block.element_id.end(), 1);
  return mesh;
}

Hexahedra extrude(const Section& section, const std::vector<double>& heights) {
  const auto layer_nodes = static_cast<LocalIndex>(section.points.size());
  Hexahedra cells;
  cells.coordinates.reserve(section.points.size() * heights.size());
  for (const double height : heights)
    for (const auto& p : section.points) cells.coordinates.emplace_back(p[0], p[1], height);
  const int layers = static_cast<int>(heights.size()) - 1;
  cells.nodes.reserve(static_cast<std::size_t>(nodes_per_element(Shape::hex8) * layers) * section.quads.size());
  for (int k = 0; k < layers; ++k)
    for (const auto& quad : section.quads)
      for (const int level : {k, k + 1})
        for (const LocalIndex corner : quad) cells.nodes.push_back(corner + level * layer_nodes);
  return cells;
}

void add_cut_planes(const Mesh& mesh, const std::string& part, const Half& half, std::vector<SurfaceSet>& sets) {
  for (int axis = 0; axis < 3; ++axis) {
    const int kept = nth(half, axis);
    if (kept == 0) continue;
    std::vector<char> in_plane;
    in_plane.reserve(mesh.coordinates.size());
    for (const Vec3& x : mesh.coordinates) in_plane.push_back(x[axis] == 0);
    sets.push_back({fmt::format("{}_{}{}", part, "xyz"[axis], kept > 0 ? "min" : "max"),
                    [in_plane](LocalIndex n) { return nth(in_plane, n) != 0; }});
  }
}

void add_surface_sets(Mesh& mesh, const std::vector<SurfaceSet>& sets) {
  const auto sides = exterior_sides(mesh);
  for (const SurfaceSet& set : sets) {
    auto& nodes = mesh.node_sets[set.name];
    for (LocalIndex n = 0; n < static_cast<LocalIndex>(mesh.coordinates.size()); ++n)
      if (set.on_surface(n)) nodes.push_back(n);
    auto& chosen = mesh.side_sets[set.name];
    for (const Side& side : sides) {
      const Block& block = nth(mesh.blocks, side.block);
      const auto face = face_nodes(block.shape, block.element(side.element), side.face);
      if (std::all_of(face.begin(), face.end(), [&](LocalIndex n) { return n == no_index || set.on_surface(n); }))
        chosen.push_back(side);
    }
  }
}

}  // namespace brunt::mesh
