// SPDX-License-Identifier: Apache-2.0
#include "mesh/resolution.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>

#include "core/cells.hpp"

namespace brunt::mesh {
std::string resolution_fault(const Mesh& mesh, double farthest) {
  double shortest = std::numeric_limits<double>::infinity(), longest = 0;
  const Block* block_of_shortest = nullptr;
  GlobalIndex element_of_shortest = 0;
  for (const Block& block : mesh.blocks)
    for (LocalIndex e = 0; e < block.count(); ++e)
      for (const auto& [a, b] : cells::of(block.shape).edges) {
        const LocalIndex i = block.element(e)[a], j = block.element(e)[b];
        if (i == j) continue;  // a collapsed corner
        const double length = (nth(mesh.coordinates, i) - nth(mesh.coordinates, j)).stableNorm();
        longest = std::max(longest, length);
        if (length >= shortest) continue;
        shortest = length;
        block_of_shortest = &block;
        element_of_shortest = nth(block.element_id, e);
      }
  if (block_of_shortest == nullptr) return {};
  for (const Vec3& x : mesh.coordinates) farthest = std::max(farthest, x.cwiseAbs().maxCoeff());
  const std::string element =
      fmt::format("element {} (block {})", element_of_shortest,
                  block_of_shortest->name.empty() ? std::to_string(block_of_shortest->id) : block_of_shortest->name);
  if (!(longest <= largest_edge) || !(shortest >= smallest_edge || shortest == 0) || !std::isfinite(farthest))
    return fmt::format("out of range: edges from {:.3g} to {:.3g} long; expected {:.0e} to {:.0e}", shortest, longest,
                       smallest_edge, largest_edge);
  if (farthest > largest_to_smallest * shortest)
    return fmt::format(
        "{}: out of range: the shortest edge, {:.3g}, is below the rounding of coordinates of {:.3g}; expected "
        "coordinates up to 2^34 (1.7e10) times the shortest edge",
        element, shortest, farthest);
  return {};
}

}  // namespace brunt::mesh
