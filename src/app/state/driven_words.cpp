// SPDX-License-Identifier: Apache-2.0
#include "driven_words.hpp"

#include <fmt/format.h>

namespace brunt::app {

std::string driven_pair(const model::Model& model, std::int32_t block, std::int32_t other) {
  const auto part = [&](std::int32_t of) -> const std::string& { return nth(model.blocks, of).part; };
  if (other < 0)
    return fmt::format("part '{}' and rigid wall '{}'", part(block), nth(model.touching.walls, -1 - other).name);
  return fmt::format("part '{}' and part '{}'", part(block), part(other));
}

std::string driven_length(double length, const std::string& length_unit) {
  return fmt::format("{:.3g}{}{}", length, length_unit.empty() ? "" : " ", length_unit);
}

std::string driven_through(const model::Model& model, std::int32_t block, std::int32_t other, double since,
                           double depth, const std::string& length_unit) {
  return fmt::format(
      "supports move {} through each other: since t = {:g} nodes that are held along the normal lie behind {} that "
      "cannot yield; the depth is now {}. Contact has no effect there (reported once for each pair; "
      "driven_penetration in summary.json is the largest depth)",
      driven_pair(model, block, other), since, other < 0 ? "a wall" : "faces", driven_length(depth, length_unit));
}

}  // namespace brunt::app
