// SPDX-License-Identifier: Apache-2.0
#include "mesh/mixed_normals.hpp"

#include <algorithm>
#include <tuple>

#include "core/cells.hpp"

namespace brunt::mesh {

MixedNormals mixed_normals(const Block& block) {
  struct Use {
    LocalIndex low, high, element;
    bool up;  ///< runs from low to high
  };
  MixedNormals mixed;
  if (!cells::is_surface(block.shape)) return mixed;
  std::vector<Use> uses;
  uses.reserve(block.nodes.size());
  for (LocalIndex e = 0; e < block.count(); ++e)
    for (const cells::Edge& edge : cells::of(block.shape).edges) {
      const LocalIndex a = block.element(e)[edge[0]], b = block.element(e)[edge[1]];
      uses.push_back({std::min(a, b), std::max(a, b), e, a < b});
    }
  const auto edge_of = [](const Use& use) { return std::tuple(use.low, use.high); };
  std::ranges::sort(uses, {}, [&](const Use& use) { return std::tuple(use.low, use.high, use.element); });
  for (std::size_t first = 0, last = 0; first < uses.size(); first = last) {
    while (last < uses.size() && edge_of(uses[last]) == edge_of(uses[first])) ++last;
    if (last - first != 2 || uses[first].up != uses[first + 1].up) continue;
    if (mixed.count++ == 0) {
      mixed.first = uses[first].element;
      mixed.second = uses[first + 1].element;
    }
  }
  return mixed;
}

}  // namespace brunt::mesh
