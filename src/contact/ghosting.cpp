// SPDX-License-Identifier: Apache-2.0
// The sparse grid between the ranks.
#include "brunt/contact/ghosting.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "brunt/comm/rendezvous.hpp"

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

/// Two cells with one key would only ghost a face too many.
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
    cell[static_cast<std::size_t>(a)] =
        std::isnan(index) ? 0 : static_cast<std::int64_t>(std::clamp(index, -limit, limit));
  }
  return cell;
}

double edge_of(int level, double finest) {
  return std::ldexp(finest, level);
}

int level_of(const geometry::Box& box, double finest) {
  const double size = (box.high - box.low).maxCoeff();
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

struct FaceCell {
  CellKey key = 0;
  LocalIndex face = 0;
};

std::vector<FaceCell> cells_of_faces(std::span<const TravellingFace> faces, double finest,
                                     std::array<double, grid_levels>& used) {
  std::vector<FaceCell> cells;
  std::vector<CellKey> keys;
  for (std::size_t f = 0; f < faces.size(); ++f) {
    const geometry::Box box = faces[f].box();
    if (!((box.high - box.low).maxCoeff() <= edge_of(grid_levels - 1, finest))) continue;  // a run that blew up
    const int level = level_of(box, finest);
    used[static_cast<std::size_t>(level)] = 1;
    keys.clear();
    append_cells(box, level, finest, keys);
    for (const CellKey key : keys) cells.push_back({key, static_cast<LocalIndex>(f)});
  }
  std::sort(cells.begin(), cells.end(), [](const FaceCell& a, const FaceCell& b) { return a.key < b.key; });
  return cells;
}

std::vector<CellKey> cells_of_points(std::span<const Vec3> points, double finest,
                                     const std::array<double, grid_levels>& used) {
  std::vector<CellKey> keys;
  for (int level = 0; level < grid_levels; ++level) {
    if (used[static_cast<std::size_t>(level)] == 0) continue;
    for (const Vec3& point : points) keys.push_back(key_of(level, cell_at(point, edge_of(level, finest))));
  }
  std::sort(keys.begin(), keys.end());
  keys.erase(std::unique(keys.begin(), keys.end()), keys.end());
  return keys;
}

/// What a rank tells a cell's home, and what the home tells the rank of a face.
struct CellUse {
  CellKey key = 0;
  Rank rank = 0;
  std::int32_t has_points = 0;  ///< else it has faces
};

std::vector<CellUse> meet_at_home(const comm::Communicator& ranks, const std::vector<FaceCell>& face_cells,
                                  const std::vector<CellKey>& point_cells) {
  std::vector<std::vector<CellUse>> to_home(static_cast<std::size_t>(ranks.size()));
  const auto tell = [&](CellKey key, bool points) {
    to_home[key % to_home.size()].push_back({key, ranks.rank(), points ? 1 : 0});
  };
  for (std::size_t i = 0; i < face_cells.size(); ++i)
    if (i == 0 || face_cells[i].key != face_cells[i - 1].key) tell(face_cells[i].key, false);
  for (const CellKey key : point_cells) tell(key, true);
  std::vector<CellUse> uses = comm::exchange(ranks, to_home).values;
  std::sort(uses.begin(), uses.end(), [](const CellUse& a, const CellUse& b) {
    if (a.key != b.key) return a.key < b.key;
    return a.has_points != b.has_points ? a.has_points < b.has_points : a.rank < b.rank;
  });

  std::vector<std::vector<CellUse>> to_faces(to_home.size());
  for (std::size_t first = 0; first < uses.size();) {
    std::size_t last = first, points = first;
    for (; last < uses.size() && uses[last].key == uses[first].key; ++last)
      if (uses[last].has_points == 0) points = last + 1;
    for (std::size_t f = first; f < points; ++f)
      for (std::size_t p = points; p < last; ++p)
        if (uses[p].rank != uses[f].rank) to_faces[static_cast<std::size_t>(uses[f].rank)].push_back(uses[p]);
    first = last;
  }
  return comm::exchange(ranks, to_faces).values;
}

}  // namespace

std::vector<TravellingFace> ghost_faces(const comm::Communicator& ranks, std::span<const TravellingFace> faces,
                                        std::span<const Vec3> points, double finest) {
  if (ranks.size() == 1) return {};
  std::array<double, grid_levels> used{};
  const std::vector<FaceCell> face_cells = cells_of_faces(faces, finest, used);
  ranks.max(used);
  const std::vector<CellUse> needs = meet_at_home(ranks, face_cells, cells_of_points(points, finest, used));

  std::vector<std::vector<LocalIndex>> leaving(static_cast<std::size_t>(ranks.size()));
  for (const CellUse& need : needs) {
    auto cell = std::lower_bound(face_cells.begin(), face_cells.end(), need.key,
                                 [](const FaceCell& a, CellKey key) { return a.key < key; });
    for (; cell != face_cells.end() && cell->key == need.key; ++cell)
      leaving[static_cast<std::size_t>(need.rank)].push_back(cell->face);
  }
  std::vector<std::vector<TravellingFace>> outgoing(leaving.size());
  for (std::size_t r = 0; r < leaving.size(); ++r) {
    std::sort(leaving[r].begin(), leaving[r].end());
    leaving[r].erase(std::unique(leaving[r].begin(), leaving[r].end()), leaving[r].end());
    for (const LocalIndex face : leaving[r]) outgoing[r].push_back(faces[static_cast<std::size_t>(face)]);
  }
  std::vector<TravellingFace> ghosts = comm::exchange(ranks, outgoing).values;
  std::sort(ghosts.begin(), ghosts.end(),
            [](const TravellingFace& a, const TravellingFace& b) { return a.key < b.key; });
  return ghosts;
}

}  // namespace brunt::contact
