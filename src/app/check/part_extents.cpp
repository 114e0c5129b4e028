// SPDX-License-Identifier: Apache-2.0
#include "part_extents.hpp"

#include <algorithm>
#include <limits>

namespace brunt::app {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr std::size_t values_per_part = 6;  // greatest x, y, z, and the greatest of -x, -y, -z: one reduction for all

}  // namespace

std::vector<Extent> part_extents(const Prepared& run) {
  const mesh::LocalMesh& mesh = run.model.mesh;
  const std::size_t parts = run.model.blocks.size();
  std::vector<double> farthest(values_per_part * parts, -infinity);
  for (std::size_t b = 0; b < parts; ++b) {
    const model::ElementBlock& block = run.model.blocks[b];
    double* const far = farthest.data() + values_per_part * b;
    for (LocalIndex e = 0; e < block.count; ++e)
      for (int corner = 0; corner < block.corners(); ++corner) {
        const Quad& place = nth(run.model.reference, block.corner_node(e, corner));
        for (std::size_t c = 0; c < 3; ++c) {
          const double x = place[static_cast<int>(c)] + mesh.origin[static_cast<int>(c)];
          far[c] = std::max(far[c], x);
          far[3 + c] = std::max(far[3 + c], -x);
        }
      }
  }
  run.links.ranks.max(farthest);
  std::vector<Extent> extents(parts);
  for (std::size_t b = 0; b < parts; ++b)
    for (std::size_t c = 0; c < 3; ++c) {
      extents[b].high[c] = farthest[values_per_part * b + c];
      extents[b].low[c] = 0.0 - farthest[values_per_part * b + 3 + c];  // no minus zero
    }
  return extents;
}

Extent together(std::span<const Extent> extents) {
  Extent all;
  all.low.fill(infinity);
  all.high.fill(-infinity);
  for (const Extent& extent : extents)
    for (std::size_t c = 0; c < 3; ++c) {
      all.low[c] = std::min(all.low[c], extent.low[c]);
      all.high[c] = std::max(all.high[c], extent.high[c]);
    }
  return all;
}

}  // namespace brunt::app
