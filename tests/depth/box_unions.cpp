// SPDX-License-Identifier: Apache-2.0
#include "tests/depth/box_unions.hpp"

#include <algorithm>
#include <array>
#include <map>

namespace brunt::test {
namespace {

using Planes = std::array<std::vector<double>, 3>;
using Cell = std::array<int, 3>;

class Grid {
 public:
  Grid(const std::vector<geometry::Box>& full, const std::vector<geometry::Box>& empty) : full_(full), empty_(empty) {
    for (int c = 0; c < 3; ++c) {
      auto& planes = planes_[static_cast<std::size_t>(c)];
      for (const auto* boxes : {&full, &empty})
        for (const geometry::Box& box : *boxes) {
          planes.push_back(box.low[c]);
          planes.push_back(box.high[c]);
        }
      std::sort(planes.begin(), planes.end());
      planes.erase(std::unique(planes.begin(), planes.end()), planes.end());
    }
  }

  TriangleSurface surface() {
    Cell cell;
    for (cell[0] = 0; cell[0] < count(0); ++cell[0])
      for (cell[1] = 0; cell[1] < count(1); ++cell[1])
        for (cell[2] = 0; cell[2] < count(2); ++cell[2])
          if (solid(cell)) add_faces(cell);
    return std::move(surface_);
  }

 private:
  [[nodiscard]] int count(std::size_t c) const { return static_cast<int>(planes_[c].size()) - 1; }
  [[nodiscard]] double plane(std::size_t c, int i) const { return planes_[c][static_cast<std::size_t>(i)]; }

  [[nodiscard]] bool solid(const Cell& cell) const {
    Vec3 middle;
    for (std::size_t c = 0; c < 3; ++c) {
      if (cell[c] < 0 || cell[c] >= count(c)) return false;
      middle[static_cast<int>(c)] = 0.5 * (plane(c, cell[c]) + plane(c, cell[c] + 1));
    }
    const auto holds = [&](const geometry::Box& box) { return geometry::contains(box, middle); };
    return std::any_of(full_.begin(), full_.end(), holds) && std::none_of(empty_.begin(), empty_.end(), holds);
  }

  LocalIndex point(const Cell& corner) {
    const auto [place, fresh] = points_.emplace(corner, static_cast<LocalIndex>(surface_.points.size()));
    if (fresh) surface_.points.emplace_back(plane(0, corner[0]), plane(1, corner[1]), plane(2, corner[2]));
    return place->second;
  }

  void add_faces(const Cell& cell) {
    for (std::size_t c = 0; c < 3; ++c)
      for (const int side : {0, 1}) {
        Cell next = cell;
        next[c] += side ? 1 : -1;
        if (solid(next)) continue;
        const std::size_t d = (c + 1) % 3, e = (c + 2) % 3;
        std::array<LocalIndex, 4> quad{};
        constexpr std::array<std::array<int, 2>, 4> round{{{0, 0}, {1, 0}, {1, 1}, {0, 1}}};
        for (std::size_t k = 0; k < 4; ++k) {
          Cell corner = cell;
          corner[c] += side;
          corner[d] += round[k][side ? 0 : 1];
          corner[e] += round[k][side ? 1 : 0];
          quad[k] = point(corner);
        }
        surface_.triangles.push_back({quad[0], quad[1], quad[2]});
        surface_.triangles.push_back({quad[0], quad[2], quad[3]});
      }
  }

  const std::vector<geometry::Box>&full_, &empty_;
  Planes planes_;
  std::map<Cell, LocalIndex> points_;
  TriangleSurface surface_;
};

}  // namespace

TriangleSurface surface_of_boxes(const std::vector<geometry::Box>& full, const std::vector<geometry::Box>& empty) {
  return Grid(full, empty).surface();
}

TriangleSurface surface_of_boxes(const std::vector<geometry::Box>& boxes) {
  const std::vector<geometry::Box> none;
  return surface_of_boxes(boxes, none);
}

geometry::Box box_between(const Vec3& low, const Vec3& high) {
  return {low, high};
}

std::vector<std::vector<Vec3>> corners_of(const std::vector<geometry::Box>& boxes) {
  std::vector<std::vector<Vec3>> pieces;
  for (const geometry::Box& box : boxes) {
    std::vector<Vec3> corners;
    for (int i = 0; i < 8; ++i)
      corners.emplace_back(i & 1 ? box.high[0] : box.low[0], i & 2 ? box.high[1] : box.low[1],
                           i & 4 ? box.high[2] : box.low[2]);
    pieces.push_back(corners);
  }
  return pieces;
}

}  // namespace brunt::test
