// SPDX-License-Identifier: Apache-2.0
#include "mesh/shell_bodies.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

#include "draw_down.hpp"
#include "hex_body.hpp"

namespace brunt::mesh {
namespace {

using Quad = std::array<LocalIndex, 4>;

struct Surface {
  std::vector<Vec3> coordinates;
  std::vector<Quad> quads;
};

/// One block, ids from 1.
Mesh shell_body(const std::string& part, Surface surface) {
  Mesh mesh;
  mesh.coordinates = std::move(surface.coordinates);
  mesh.node_id.resize(mesh.coordinates.size());
  std::iota(mesh.node_id.begin(), mesh.node_id.end(), 1);
  Block& block = mesh.blocks.emplace_back(Block{part, 1, Shape::quad4, {}, {}});
  for (const Quad& quad : surface.quads) block.nodes.insert(block.nodes.end(), quad.begin(), quad.end());
  block.element_id.resize(surface.quads.size());
  std::iota(block.element_id.begin(), block.element_id.end(), 1);
  return mesh;
}

constexpr std::int32_t top = 0, bottom = 1;  ///< sides of a shell

/// All nodes, and the tops or bottoms of all elements.
void add_whole_side(Mesh& mesh, const std::string& name, std::int32_t which) {
  std::vector<LocalIndex>& nodes = mesh.node_sets[name];
  nodes.resize(mesh.coordinates.size());
  std::iota(nodes.begin(), nodes.end(), 0);
  for (LocalIndex e = 0; e < mesh.blocks[0].count(); ++e) mesh.side_sets[name].push_back({0, e, which});
}

void add_edges(Mesh& mesh, const std::vector<SurfaceSet>& edges) {
  for (const SurfaceSet& edge : edges) {
    std::vector<LocalIndex>& nodes = mesh.node_sets[edge.name];
    for (LocalIndex n = 0; n < static_cast<LocalIndex>(mesh.coordinates.size()); ++n)
      if (edge.on_surface(n)) nodes.push_back(n);
  }
}

/// A cell of the grid of a box, by its node numbers along x, y, z.
using Place = std::array<int, 3>;

/// The six sides of a grid of cells, without the open ones: sides one after the other, quadrilaterals with outward
/// normals. Nodes are numbered by first touch.
struct Skin {
  std::vector<Place> nodes;
  std::vector<Quad> quads;
  std::vector<int> side;  ///< of each quadrilateral, in the order of BoxSides
};

Skin skin_of(const std::array<int, 3>& cells, const BoxSides& open) {
  Skin skin;
  std::map<Place, LocalIndex> number;
  const auto node = [&](const Place& place) {
    const auto [found, fresh] = number.try_emplace(place, static_cast<LocalIndex>(skin.nodes.size()));
    if (fresh) skin.nodes.push_back(place);
    return found->second;
  };
  for (std::size_t side = 0; side < open.size(); ++side) {
    if (open[side]) continue;
    const bool high = side % 2 == 1;
    const std::size_t across = side / 2, a = (across + 1) % 3, b = (across + 2) % 3;  // a x b points along `across`
    for (int j = 0; j < cells[b]; ++j)
      for (int i = 0; i < cells[a]; ++i) {
        Quad quad{};
        for (std::size_t k = 0; k < 4; ++k) {
          Place place{};
          place[across] = high ? cells[across] : 0;
          place[a] = i + (k == 1 || k == 2 ? 1 : 0);
          place[b] = j + (k >= 2 ? 1 : 0);
          quad[k] = node(place);
        }
        if (!high) std::swap(quad[1], quad[3]);
        skin.quads.push_back(quad);
        skin.side.push_back(static_cast<int>(side));
      }
  }
  return skin;
}

constexpr std::array<const char*, 6> side_names{"_xmin", "_xmax", "_ymin", "_ymax", "_zmin", "_zmax"};

/// Keeps the quadrilaterals whose nodes are all on the sides that are kept, and their nodes in order.
void keep_half(Surface& surface, const Half& half) {
  const auto inside = [&](LocalIndex n) {
    const Vec3& x = nth(surface.coordinates, n);
    return half[0] * x[0] >= 0 && half[1] * x[1] >= 0 && half[2] * x[2] >= 0;
  };
  std::erase_if(surface.quads, [&](const Quad& quad) { return !std::ranges::all_of(quad, inside); });
  std::vector<LocalIndex> number(surface.coordinates.size(), no_index);
  for (const Quad& quad : surface.quads)
    for (const LocalIndex n : quad) nth(number, n) = 0;
  std::vector<Vec3> kept;
  for (std::size_t n = 0; n < number.size(); ++n) {
    if (number[n] == no_index) continue;
    number[n] = static_cast<LocalIndex>(kept.size());
    kept.push_back(surface.coordinates[n]);
  }
  for (Quad& quad : surface.quads)
    for (LocalIndex& n : quad) n = nth(number, n);
  surface.coordinates = std::move(kept);
}

}  // namespace

Mesh shell_plate(const std::string& part, const std::array<double, 2>& size, const Divisions<2>& elements) {
  ParameterCheck check("plate " + part);
  for (const double s : size) check.positive("size", s);
  for (const Division& n : elements) check.divided("elements", n, 1);
  check.fits((elements[0] + 1.0) * (elements[1] + 1.0));
  check.finish();
  const Section section =
      rectangle(places(elements[0], -size[0] / 2, size[0] / 2), places(elements[1], -size[1] / 2, size[1] / 2));
  Surface surface{{}, section.quads};
  for (const auto& [x, y] : section.points) surface.coordinates.emplace_back(x, y, 0);
  Mesh mesh = shell_body(part, std::move(surface));
  const int nx = elements[0], ny = elements[1];
  add_edges(mesh, {{part + "_xmin", [=](LocalIndex n) { return n % (nx + 1) == 0; }},
                   {part + "_xmax", [=](LocalIndex n) { return n % (nx + 1) == nx; }},
                   {part + "_ymin", [=](LocalIndex n) { return n / (nx + 1) == 0; }},
                   {part + "_ymax", [=](LocalIndex n) { return n / (nx + 1) == ny; }}});
  add_whole_side(mesh, part + "_zmax", top);
  add_whole_side(mesh, part + "_zmin", bottom);
  return mesh;
}

Mesh shell_tube(const std::string& part, double radius, double length, const Divisions<2>& elements,
                const RoundForm& form) {
  ParameterCheck check("tube " + part);
  check.positive("radius", radius);
  check.positive("length", length);
  check.at_least("elements around", elements[0], form.sector.cuts() ? 1 : 3);
  check.holds(elements[0].is_even(), "invalid sizes of elements around; expected equal elements");
  check.divided("elements along the axis", elements[1], 1);
  check.holds(form.nose.shape == Nose::Shape::none, "invalid nose of a tube of shells; expected none");
  check.fits((elements[0] + 1.0) * (elements[1] + 1.0));
  const int parts = (form.half[0] != 0 ? 2 : 1) * (form.half[1] != 0 ? 2 : 1);
  check.holds(elements[0] % parts == 0,
              fmt::format("invalid number of elements around: {} cannot be divided into {} equal parts; expected a "
                          "multiple of {}",
                          elements[0], parts, parts));
  check.finish();
  bool closed = true;
  const std::vector<std::array<double, 2>> rays = ray_directions(elements[0], form, closed);
  const std::vector<double> heights = places(elements[1], 0, length);
  const auto row = static_cast<LocalIndex>(rays.size()), cells = closed ? row : row - 1,
             layers = static_cast<LocalIndex>(heights.size()) - 1;
  Surface surface;
  for (const double z : heights)
    for (const auto& [cosine, sine] : rays) surface.coordinates.emplace_back(radius * cosine, radius * sine, z);
  for (LocalIndex k = 0; k < layers; ++k)
    for (LocalIndex c = 0; c < cells; ++c) {
      const LocalIndex next = (c + 1) % row;
      surface.quads.push_back({c + k * row, next + k * row, next + (k + 1) * row, c + (k + 1) * row});
    }
  Mesh mesh = shell_body(part, std::move(surface));
  std::vector<SurfaceSet> edges{{part + "_bottom", [=](LocalIndex n) { return n < row; }},
                                {part + "_top", [=](LocalIndex n) { return n >= layers * row; }}};
  add_cut_planes(mesh, part, form.half, edges);
  if (form.sector.cuts()) {
    edges.push_back({part + "_from", [=](LocalIndex n) { return n % row == 0; }});
    edges.push_back({part + "_to", [=](LocalIndex n) { return n % row == row - 1; }});
  }
  add_edges(mesh, edges);
  add_whole_side(mesh, part + "_side", top);
  add_whole_side(mesh, part + "_inner", bottom);
  return mesh;
}

Mesh shell_box(const std::string& part, const Vec3& size, const Divisions<3>& elements, const BoxSides& open) {
  ParameterCheck check("box " + part);
  for (int i = 0; i < 3; ++i) {
    check.positive("size", size[i]);
    check.divided("elements", nth(elements, i), 1);
  }
  const double nx = elements[0], ny = elements[1], nz = elements[2];
  check.fits(2 * ((nx + 1) * (ny + 1) + (ny + 1) * (nz + 1) + (nz + 1) * (nx + 1)));
  check.holds(std::ranges::find(open, false) != open.end(), "invalid open: all six sides; expected at most five");
  check.finish();
  const std::array<int, 3> cells{elements[0], elements[1], elements[2]};
  const Skin skin = skin_of(cells, open);
  std::array<std::vector<double>, 3> along;
  for (std::size_t i = 0; i < 3; ++i) along[i] = places(elements[i], 0, size[static_cast<Eigen::Index>(i)]);
  Surface surface{{}, skin.quads};
  for (const auto& [i, j, k] : skin.nodes)
    surface.coordinates.emplace_back(nth(along[0], i), nth(along[1], j), nth(along[2], k));
  Mesh mesh = shell_body(part, std::move(surface));
  for (std::size_t side = 0; side < open.size(); ++side) {
    const std::string name = part + side_names[side];
    add_edges(
        mesh,
        {{name, [&](LocalIndex n) { return nth(skin.nodes, n)[side / 2] == (side % 2 == 1 ? cells[side / 2] : 0); }}});
    if (open[side]) continue;
    for (std::size_t e = 0; e < skin.side.size(); ++e)
      if (skin.side[e] == static_cast<int>(side)) mesh.side_sets[name].push_back({0, static_cast<LocalIndex>(e), top});
  }
  return mesh;
}

Mesh shell_sphere(const std::string& part, double radius, int elements, const SphereForm& form) {
  check_sphere(part, radius, elements, form);
  const RoundedCore core(radius, elements);
  const int k = core.half_cells();
  const Skin skin = skin_of({2 * k, 2 * k, 2 * k}, {});
  Surface surface{{}, skin.quads};
  for (const auto& [i, j, l] : skin.nodes)
    surface.coordinates.push_back(core.outside({i - k, j - k, l - k}, core.shells()));
  keep_half(surface, form.half);
  Mesh mesh = shell_body(part, std::move(surface));
  std::vector<SurfaceSet> edges;
  add_cut_planes(mesh, part, form.half, edges);  // before the map, which keeps these planes to rounding
  draw_down(mesh.coordinates, radius, form);
  add_edges(mesh, edges);
  add_whole_side(mesh, part + "_surface", top);
  return mesh;
}

}  // namespace brunt::mesh
