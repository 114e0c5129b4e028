// SPDX-License-Identifier: Apache-2.0
#include "model/alive.hpp"

#include <algorithm>

#include "core/cells.hpp"
#include "core/error.hpp"

namespace brunt::model {
namespace {

/// A bit for each living lane, batch by batch; padding repeats the last element. Empty if all live.
std::vector<std::uint8_t> living_lanes(const ElementBlock& block, const std::vector<double>& alive) {
  if (std::ranges::all_of(alive, [](double flag) { return flag > 0; })) return {};
  static_assert(pack_width <= 8);
  constexpr auto all = static_cast<std::uint8_t>(0xff);
  std::vector<std::uint8_t> lanes(static_cast<std::size_t>(block.batches()), all);
  for (LocalIndex batch = 0; batch < block.batches(); ++batch) {
    std::uint8_t& bits = nth(lanes, batch);
    for (int lane = 0; lane < pack_width; ++lane) {
      const LocalIndex element = std::min(batch * pack_width + lane, block.count - 1);
      if (nth(alive, element) <= 0) bits = static_cast<std::uint8_t>(bits & ~(1U << lane));
    }
    if (static_cast<std::uint8_t>(bits << (8 - pack_width)) == 0) bits = 0;  // clears bits beyond the width of a pack
  }
  return lanes;
}

}  // namespace

bool lives(const Model& model, const State& state, const mesh::ExteriorFace& face) {
  const auto b = static_cast<std::size_t>(face.block);
  if (b >= state.alive.size() || state.alive[b].empty()) return true;
  const std::vector<GlobalIndex>& gid = model.blocks[b].gid;
  const auto found = std::ranges::lower_bound(gid, cells::element_of_key(face.key));
  demand(found != gid.end() && *found == cells::element_of_key(face.key), "the element of a face is on its rank");
  return lives(state, b, static_cast<LocalIndex>(found - gid.begin()));
}

Living follow(const Model& model, const State& state) {
  Living living;
  if (state.alive.empty()) return living;
  for (std::size_t b = 0; b < model.blocks.size(); ++b)
    living.lanes.push_back(living_lanes(model.blocks[b], state.alive[b]));
  for (const PressureLoad& load : model.loads.pressure) {
    std::vector<char>& pressed = living.pressed.emplace_back();
    for (const mesh::ExteriorFace& face : load.faces) pressed.push_back(lives(model, state, face) ? 1 : 0);
  }
  return living;
}

}  // namespace brunt::model
