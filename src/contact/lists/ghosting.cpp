// SPDX-License-Identifier: Apache-2.0
// The sparse grid between the ranks.
#include "contact/lists/ghosting.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

#include "comm/rendezvous.hpp"

namespace brunt::contact {
namespace {

using CellKey = std::uint64_t;
constexpr int grid_levels = 60;  // each twice as coarse as the one before

CellKey mix(CellKey value) {  // finaliser of splitmix64
  value ^= value >> 30;
  value *= 0xBF58476D1CE4E5B9ULL;
  value ^= value >> 27;
  value *= 0x94D049BB133111EBULL;
  return value ^ (value >> 31);
}

/// Two cells with the same key would only cause an additional ghost face.
CellKey key_of(int level, const std::array<std::int64_t, 3>& cell) {
  CellKey key = mix(static_cast<CellKey>(level) + 1);
  for (const std::int64_t index : cell) key = mix(key + static_cast<CellKey>(index) * 0x9E3779B97F4A7C15ULL);
  return key;
}

std::array<std::int64_t, 3> cell_at(const Vec3& point, double edge) {
  constexpr double limit = 4e18;  // beyond, all falls into one layer of cells
  std::array<std::int64_t, 3> cell{};
  for (int a = 0; a < 3; ++a) {
    const double index = std::floor(point[a] / edge);
    nth(cell, a) = std::isnan(index) ? 0 : static_cast<std::int64_t>(std::clamp(index, -limit, limit));
  }
  return cell;
}

double edge_of(int level, double finest) {
  return std::ldexp(finest, level);
}

/// The longest side [length]: infinite where a bound is, or where it is no number of the machine; NaN if a bound is.
double extent_of(const geometry::Box& box) {
  if (box.low.hasNaN() || box.high.hasNaN()) return std::numeric_limits<double>::quiet_NaN();
  if (!box.low.allFinite() || !box.high.allFinite()) return std::numeric_limits<double>::infinity();
  return (box.high - box.low).maxCoeff();
}

int level_of(const geometry::Box& box, double finest) {
  const double size = extent_of(box);
  int level = 0;
  while (level + 1 < grid_levels && edge_of(level, finest) < size) ++level;
  return level;
}

void append_cells(const geometry::Box& box, int level, double finest, std::vector<CellKey>& keys) {
  const auto low = cell_at(box.low, edge_of(level, finest)), high = cell_at(box.high, edge_of(level, finest));
  std::array<std::int64_t, 3> cell{};
  for (cell[0] = low[0]; cell[0] <= high[0]; ++cell[0])
    for (cell[1] = low[1]; cell[1] <= high[1]; ++cell[1])
      for (cell[2] = low[2]; cell[2] <= high[2]; ++cell[2]) keys.push_back(key_of(level, cell));
}

struct BoxCell {
  CellKey key = 0;
  LocalIndex box = 0;
  std::int32_t own_level = 0;  ///< 1 on the level that fits the box's size
};

using Levels = std::array<double, grid_levels>;  // 1 where used

bool too_large(const geometry::Box& box, double finest) {  // a run that blew up
  return !(extent_of(box) <= edge_of(grid_levels - 1, finest));
}

Levels own_levels(const comm::Communicator& ranks, std::span<const geometry::Box> boxes, double finest) {
  Levels used{};
  for (const geometry::Box& box : boxes)
    if (!too_large(box, finest)) nth(used, level_of(box, finest)) = 1;
  ranks.max(used);
  return used;
}

/// Cells of boxes on their own level and on the coarser ones that the others use, in order of their keys.
std::vector<BoxCell> cells_of(std::span<const geometry::Box> boxes, double finest, const Levels& others) {
  std::vector<BoxCell> cells;
  std::vector<CellKey> keys;
  for (std::size_t b = 0; b < boxes.size(); ++b) {
    if (too_large(boxes[b], finest)) continue;
    const int own = level_of(boxes[b], finest);
    for (int level = own; level < grid_levels; ++level) {
      if (level != own && nth(others, level) == 0) continue;
      keys.clear();
      append_cells(boxes[b], level, finest, keys);
      for (const CellKey key : keys) cells.push_back({key, static_cast<LocalIndex>(b), level == own ? 1 : 0});
    }
  }
  std::sort(cells.begin(), cells.end(),
            [](const BoxCell& a, const BoxCell& b) { return a.key != b.key ? a.key < b.key : a.box < b.box; });
  return cells;
}

/// What a rank reports to the home of a cell, and the home to the rank that offers.
struct CellUse {
  CellKey key = 0;
  Rank rank = 0;
  std::int32_t wants = 0;      ///< else it offers
  std::int32_t own_level = 0;  ///< some box of the rank has the size of this cell
};

/// One entry a cell, of a rank's cells in order.
void report_to_homes(const std::vector<BoxCell>& cells, Rank rank, bool wants,
                     std::vector<std::vector<CellUse>>& to_home) {
  for (std::size_t first = 0, last = 0; first < cells.size(); first = last) {
    CellUse use{cells[first].key, rank, wants ? 1 : 0, 0};
    for (; last < cells.size() && cells[last].key == use.key; ++last)
      use.own_level = std::max(use.own_level, cells[last].own_level);
    to_home[use.key % to_home.size()].push_back(use);
  }
}

/// Two boxes meet on the level of the larger one: at least one of them is at home there.
std::vector<CellUse> meet_at_home(const comm::Communicator& ranks, const std::vector<BoxCell>& offered,
                                  const std::vector<BoxCell>& wanted) {
  std::vector<std::vector<CellUse>> to_home(static_cast<std::size_t>(ranks.size()));
  report_to_homes(offered, ranks.rank(), false, to_home);
  report_to_homes(wanted, ranks.rank(), true, to_home);
  std::vector<CellUse> uses = comm::exchange(ranks, to_home).values;
  std::sort(uses.begin(), uses.end(), [](const CellUse& a, const CellUse& b) {
    if (a.key != b.key) return a.key < b.key;
    return a.wants != b.wants ? a.wants < b.wants : a.rank < b.rank;
  });

  std::vector<std::vector<CellUse>> to_offering(to_home.size());
  for (std::size_t first = 0; first < uses.size();) {
    std::size_t last = first, wanting = first;
    for (; last < uses.size() && uses[last].key == uses[first].key; ++last)
      if (uses[last].wants == 0) wanting = last + 1;
    for (std::size_t o = first; o < wanting; ++o)
      for (std::size_t w = wanting; w < last; ++w)
        if (uses[w].rank != uses[o].rank && (uses[w].own_level != 0 || uses[o].own_level != 0))
          nth(to_offering, uses[o].rank).push_back(uses[w]);
    first = last;
  }
  return comm::exchange(ranks, to_offering).values;
}

}  // namespace

double finest_cell(const comm::Communicator& ranks, std::span<const geometry::Box> boxes) {
  double smallest = std::numeric_limits<double>::infinity(), largest = 0;
  for (const geometry::Box& box : boxes) {
    const double extent = extent_of(box);
    if (!(extent > 0) || !std::isfinite(extent)) continue;
    smallest = std::min(smallest, extent);
    largest = std::max(largest, extent);
  }
  smallest = ranks.min(smallest);
  largest = ranks.max(largest);
  return largest > 0 ? std::max(smallest, std::ldexp(largest, -50)) : 1.0;
}

std::vector<std::vector<LocalIndex>> meet_in_cells(const comm::Communicator& ranks,
                                                   std::span<const geometry::Box> offered,
                                                   std::span<const geometry::Box> wanted, double finest) {
  std::vector<std::vector<LocalIndex>> leaving(static_cast<std::size_t>(ranks.size()));
  if (ranks.size() == 1) return leaving;
  const Levels offered_levels = own_levels(ranks, offered, finest), wanted_levels = own_levels(ranks, wanted, finest);
  const std::vector<BoxCell> offered_cells = cells_of(offered, finest, wanted_levels);
  const std::vector<CellUse> needs = meet_at_home(ranks, offered_cells, cells_of(wanted, finest, offered_levels));
  for (const CellUse& need : needs) {
    auto cell = std::lower_bound(offered_cells.begin(), offered_cells.end(), need.key,
                                 [](const BoxCell& a, CellKey key) { return a.key < key; });
    for (; cell != offered_cells.end() && cell->key == need.key; ++cell)
      if (cell->own_level != 0 || need.own_level != 0) nth(leaving, need.rank).push_back(cell->box);
  }
  for (std::size_t b = 0; b < offered.size(); ++b)  // no grid holds it
    if (extent_of(offered[b]) > edge_of(grid_levels - 1, finest))
      for (Rank r = 0; r < ranks.size(); ++r)
        if (r != ranks.rank()) nth(leaving, r).push_back(static_cast<LocalIndex>(b));
  for (std::vector<LocalIndex>& boxes : leaving) {
    std::sort(boxes.begin(), boxes.end());
    boxes.erase(std::unique(boxes.begin(), boxes.end()), boxes.end());
  }
  return leaving;
}

}  // namespace brunt::contact
