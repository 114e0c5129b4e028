// SPDX-License-Identifier: Apache-2.0
#include "outer_surface.hpp"

#include <Eigen/Geometry>
#include <array>
#include <vector>

#include "core/cells.hpp"
#include "mesh/topology.hpp"

namespace brunt::app {
namespace {

/// Six times the volume between the triangle and the origin.
double six_volumes(const Vec3& a, const Vec3& b, const Vec3& c) {
  return a.dot(b.cross(c));
}

}  // namespace

TriangleSurface outer_surface(const mesh::Mesh& mesh, std::size_t block) {
  mesh::Mesh alone;
  alone.blocks = {mesh.blocks[block]};
  alone.coordinates = mesh.coordinates;
  TriangleSurface surface;
  std::vector<LocalIndex> number(mesh.coordinates.size(), no_index);
  const auto point = [&](LocalIndex node) {
    LocalIndex& at = nth(number, node);
    if (at == no_index) {
      at = static_cast<LocalIndex>(surface.points.size());
      surface.points.push_back(nth(mesh.coordinates, node));
    }
    return at;
  };
  for (const mesh::Side& side : mesh::exterior_sides(alone)) {
    const mesh::Block& own = alone.blocks[0];
    const std::array<LocalIndex, 4> nodes = mesh::face_nodes(own.shape, own.element(side.element), side.face);
    if (nodes[0] == no_index) continue;
    std::array<LocalIndex, 4> p{};
    const std::size_t count = cells::corner_count(nodes);
    for (std::size_t i = 0; i < count; ++i) p[i] = point(nodes[i]);
    if (count == 3) {
      surface.triangles.push_back({p[0], p[1], p[2]});
      continue;
    }
    const auto x = [&](std::size_t i) -> const Vec3& { return nth(surface.points, p[i]); };
    const Vec3 b = x(1) - x(0), c = x(2) - x(0), d = x(3) - x(0);
    if (six_volumes(b, c, d) <= 0) {  // the diagonal 0-2 lies farther out
      surface.triangles.push_back({p[0], p[1], p[2]});
      surface.triangles.push_back({p[0], p[2], p[3]});
    } else {
      surface.triangles.push_back({p[0], p[1], p[3]});
      surface.triangles.push_back({p[1], p[2], p[3]});
    }
  }
  return surface;
}

}  // namespace brunt::app
