// SPDX-License-Identifier: Apache-2.0
#include "contact/detection/tilts.hpp"

#include "core/error.hpp"

namespace brunt::contact {
bool has_tilts(const Row& row) {
  return row.is_mortar() && (row.friction > 0 || row.lagging > 0) && !row.holds;
}

void TiltStore::start(std::span<const Row> rows) {
  std::size_t points = 0;
  for (const Row& row : rows)
    if (has_tilts(row)) points += row.points().size();
  values.resize(points);
  used = 0;
}

std::span<Vec3> TiltStore::next(std::size_t count) {
  demand(used + count <= values.size(), "room for the tilts of rows with friction");
  const std::span<Vec3> room = std::span(values).subspan(used, count);
  used += count;
  return room;
}

}  // namespace brunt::contact
