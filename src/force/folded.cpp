// SPDX-License-Identifier: Apache-2.0
#include "force/folded.hpp"

#include <algorithm>
#include <array>
#include <limits>

#include "block_loop.hpp"
#include "core/cells.hpp"
#include "model/alive.hpp"

namespace brunt::force {
namespace {

constexpr int hex_corners = cells::of(cells::Shape::hex8).corners;

/// Smallest Jacobian at a corner over the one of largest magnitude, for each element of a batch.
Pack least_of_corners(const Pack (&x)[3][hex_corners]) {
  Pack least = broadcast(std::numeric_limits<double>::max()), largest = broadcast(0.0);
  for (std::size_t k = 0; k < hex_corners; ++k) {
    const auto [a, b, c] = cells::hex_neighbours[k];
    Pack u[3], v[3], w[3];
    for (int i = 0; i < 3; ++i) {
      u[i] = x[i][a] - x[i][k];
      v[i] = x[i][b] - x[i][k];
      w[i] = x[i][c] - x[i][k];
    }
    const Pack jacobian =
        u[0] * (v[1] * w[2] - v[2] * w[1]) + u[1] * (v[2] * w[0] - v[0] * w[2]) + u[2] * (v[0] * w[1] - v[1] * w[0]);
    least = pack_min(least, jacobian);
    largest = pack_max(largest, pack_abs(jacobian));
  }
  return least / largest;
}

void look_at(const model::ElementBlock& block, std::int32_t index, const model::State& state, FoldedElements& folded) {
  constexpr double flat = -1e-6;
  Pack x[3][hex_corners];
  for (LocalIndex batch = 0; batch < block.batches(); ++batch) {
    const LocalIndex* node = block.node.data() + static_cast<std::ptrdiff_t>(batch) * hex_corners * pack_width;
    for (int c = 0; c < hex_corners; ++c) {
      const LocalIndex* corner = node + c * pack_width;
      const auto position = [&](int lane) { return *reinterpret_cast<const Quad*>(nth(state.nodes, corner[lane]).x); };
      components_of(position, x[0][c], x[1][c], x[2][c]);
    }
    const Pack least = least_of_corners(x);
    if (!any(least < flat)) continue;
    const int lanes = std::min(pack_width, block.count - batch * pack_width);
    for (int lane = 0; lane < lanes; ++lane) {
      if (!(least[lane] < flat) || !model::lives(state, static_cast<std::size_t>(index), batch * pack_width + lane))
        continue;
      ++folded.count;
      const GlobalIndex element =
          block.input[static_cast<std::size_t>(batch) * pack_width + static_cast<std::size_t>(lane)];
      if (least[lane] > folded.worst || (least[lane] == folded.worst && element < folded.element)) continue;
      folded.worst = least[lane];
      folded.element = element;
      folded.block = index;
    }
  }
}

}  // namespace

FoldedElements folded_elements(const model::Model& model, const model::State& state) {
  FoldedElements folded;
  for (std::size_t b = 0; b < model.blocks.size(); ++b)
    if (model.blocks[b].shape == cells::Shape::hex8 && !material::is_rigid(model.blocks[b].law))
      look_at(model.blocks[b], static_cast<std::int32_t>(b), state, folded);
  return folded;
}

}  // namespace brunt::force
