// SPDX-License-Identifier: Apache-2.0
#include "element_place.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <limits>
#include <span>

#include "core/cells.hpp"
#include "model/alive.hpp"

namespace brunt::app {
namespace {

using Corners = std::array<Vec3, cells::most_corners>;

/// Over that of the reference. Wedges have edges between corners that are one node: they are none.
double shortest_edge(const Corners& x, const Corners& reference, const cells::Cell& cell) {
  double now = std::numeric_limits<double>::infinity(), first = now;
  for (const cells::Edge& edge : cell.edges) {
    const auto a = static_cast<std::size_t>(edge[0]), b = static_cast<std::size_t>(edge[1]);
    if (reference[a] == reference[b]) continue;
    now = std::min(now, (x[b] - x[a]).norm());
    first = std::min(first, (reference[b] - reference[a]).norm());
  }
  return now / first;
}

/// Area of a shell, in two triangles: its tetrahedra are none.
double area(const Corners& x, const cells::Cell& cell) {
  double sum = 0;
  for (std::size_t c = 1; c + 1 < static_cast<std::size_t>(cell.corners); ++c)
    sum += 0.5 * (x[c] - x[0]).cross(x[c + 1] - x[0]).norm();
  return sum;
}

double volume(const Corners& x, const cells::Cell& cell) {
  if (cell.dimension == 2) return area(x, cell);
  const auto of = [&](const cells::Tetrahedron& tet) {
    const auto from_first = [&](std::size_t i) { return Vec3(nth(x, tet[i]) - nth(x, tet[0])); };
    return from_first(1).cross(from_first(2)).dot(from_first(3)) / 6;
  };
  double sum = 0;
  for (const cells::Tetrahedron& tet : cell.tetrahedra) sum += of(tet);
  return sum;
}

/// center, then ratios of edge and volume.
std::array<double, 5> figures_of(const Prepared& run, const model::ElementBlock& block, LocalIndex element) {
  Corners now, first;
  Vec3 center = Vec3::Zero();
  for (int c = 0; c < block.corners(); ++c) {
    const auto node = static_cast<std::size_t>(block.corner_node(element, c));
    const auto corner = static_cast<std::size_t>(c);
    now[corner] = Vec3(run.state.nodes[node].x);
    first[corner] = Vec3(run.model.reference[node][0], run.model.reference[node][1], run.model.reference[node][2]);
    center += now[corner] / block.corners();
  }
  const cells::Cell& cell = cells::of(block.shape);
  return {center[0], center[1], center[2], shortest_edge(now, first, cell), volume(now, cell) / volume(first, cell)};
}

}  // namespace

ElementPlace place_of(const Prepared& run, std::int32_t block, LocalIndex element) {
  const comm::Communicator& ranks = run.links.ranks;
  GlobalIndex mine = -1;
  if (block >= 0) mine = nth(nth(run.model.blocks, block).input, element);
  ElementPlace place;
  place.element = ranks.max(mine);
  if (place.element < 0) return place;
  const bool here = mine == place.element;
  std::array<double, 5> figures;
  figures.fill(-std::numeric_limits<double>::infinity());
  if (here) figures = figures_of(run, nth(run.model.blocks, block), element);
  ranks.max(figures);
  place.block = static_cast<std::int32_t>(ranks.max(GlobalIndex{here ? block : -1}));
  place.part = nth(run.model.blocks, place.block).part;
  place.center = Vec3(figures[0], figures[1], figures[2]) + run.model.mesh.origin;
  place.shortest_edge = figures[3];
  place.volume = figures[4];
  return place;
}

ElementPlace place_of_least(const Prepared& run, const std::string& field) {
  double least = std::numeric_limits<double>::infinity();
  std::int32_t in_block = -1;
  LocalIndex of = -1;
  for (std::size_t b = 0; b < run.model.blocks.size(); ++b) {
    const model::ElementBlock& block = run.model.blocks[b];
    const model::HistoryRange* range = block.find(field);
    if (!range) continue;
    for (LocalIndex e = 0; e < block.count; ++e) {
      if (!model::lives(run.state, b, e)) continue;
      const std::ptrdiff_t row = std::ptrdiff_t{e / pack_width} * block.history_size + range->first;
      const double value = nth(run.state.history[b], row * pack_width + e % pack_width);
      const bool later =
          of >= 0 && value == least && nth(block.input, e) > nth(nth(run.model.blocks, in_block).input, of);
      if (!(value < least) && !later) continue;
      least = value;
      in_block = static_cast<std::int32_t>(b);
      of = e;
    }
  }
  if (run.links.ranks.min(least) != least) in_block = -1;
  return place_of(run, in_block, of);
}

std::string text_of(const ElementPlace& place) {
  return fmt::format("element {} (position in the input) of part '{}' at ({:g}, {:g}, {:g})", place.element + 1,
                     place.part, place.center[0], place.center[1], place.center[2]);
}

std::string text_of_point(const Prepared& run, const Vec3& position) {
  const Vec3 place = position + run.model.mesh.origin;
  return fmt::format("({:g}, {:g}, {:g})", place[0], place[1], place[2]);
}

std::string name_of_node(const Prepared& run, GlobalIndex gid) {
  const model::Model& model = run.model;
  GlobalIndex id = -1, part = -1;
  for (const LocalIndex node : model.owned) {
    const auto i = static_cast<std::size_t>(node);
    if (model.mesh.node_gid[i] == gid) id = model.mesh.node_id[i];
  }
  for (std::size_t b = 0; b < model.blocks.size(); ++b)
    for (const LocalIndex node : model.blocks[b].node)
      if (nth(model.mesh.node_gid, node) == gid) part = static_cast<GlobalIndex>(b);
  id = run.links.ranks.max(id);
  part = run.links.ranks.max(part);
  if (part < 0) return fmt::format("node {}", id);
  return fmt::format("part {}, node {}", nth(model.blocks, part).part, id);
}

}  // namespace brunt::app
