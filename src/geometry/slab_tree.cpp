// SPDX-License-Identifier: Apache-2.0
#include "brunt/geometry/slab_tree.hpp"

#include <cmath>
#include <stdexcept>

#include "pseudo_normals.hpp"

namespace brunt::geometry {

std::vector<Vec3> more_directions(int count) {
  if (count != 3 && count != 7 && count != 9 && count != 13)
    throw std::invalid_argument("slab directions: expected 3, 7, 9 or 13");
  std::vector<Vec3> directions;
  if (count == 9 || count == 13) directions = {{0, 1, 1}, {0, 1, -1}, {1, 0, 1}, {-1, 0, 1}, {1, 1, 0}, {1, -1, 0}};
  if (count == 7 || count == 13)
    for (const Vec3& diagonal : {Vec3(1, 1, 1), Vec3(-1, 1, 1), Vec3(1, -1, 1), Vec3(1, 1, -1)})
      directions.push_back(diagonal);
  return directions;
}

SlabTree build_slab_tree(const TriangleSurface& surface, std::span<const Vec3> directions) {
  SlabTree tree;
  for (const Vec3& direction : directions) tree.directions.push_back(direction.normalized());
  for (const auto& corners : surface.triangles) {
    Triangle& triangle = tree.triangles.emplace_back();
    for (std::size_t i = 0; i < 3; ++i) {
      triangle[i] = surface.points[static_cast<std::size_t>(corners[i])];
      extend(tree.box, triangle[i]);
    }
  }
  tree.normals = pseudo_normals(tree.triangles);
  return tree;
}

}  // namespace brunt::geometry
