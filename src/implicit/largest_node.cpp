// SPDX-License-Identifier: Apache-2.0
#include "largest_node.hpp"

#include <cmath>

namespace brunt::implicit {

LargestNode largest_node(const Scene& scene, const Solver& solver, std::span<const double> values) {
  LargestNode most;
  for (std::size_t k = 0; k < solver.unknowns.node.size(); ++k) {
    const double size = Vec3(&values[3 * k]).norm();
    if (size > most.size || std::isnan(size)) most = {size, nth(scene.model.mesh.node_gid, solver.unknowns.node[k])};
  }
  const double largest = scene.links.ranks.max(most.size);
  const GlobalIndex mine = most.size == largest && most.gid >= 0 ? -most.gid : -scene.model.mesh.global_nodes;
  const GlobalIndex gid = -scene.links.ranks.max(mine);
  return {largest, gid < scene.model.mesh.global_nodes ? gid : -1};
}

}  // namespace brunt::implicit
