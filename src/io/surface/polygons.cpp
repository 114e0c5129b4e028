// SPDX-License-Identifier: Apache-2.0
// Polygons of a file to triangles (see the header).
#include "polygons.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <limits>
#include <span>

#include "core/error.hpp"
#include "ear_clipping.hpp"

namespace brunt::io {
namespace {

using Corners = std::span<const LocalIndex>;

/// A corner that the face names twice, or no_index.
LocalIndex repeated(Corners corners, std::vector<LocalIndex>& sorted) {
  if (corners.size() == 3) {
    if (corners[0] == corners[1] || corners[0] == corners[2]) return corners[0];
    return corners[1] == corners[2] ? corners[1] : no_index;
  }
  sorted.assign(corners.begin(), corners.end());
  std::ranges::sort(sorted);
  const auto found = std::ranges::adjacent_find(sorted);
  return found == sorted.end() ? no_index : *found;
}

std::string fault_of(Split split, std::size_t corners) {
  if (split == Split::too_concave)
    return fmt::format("invalid face of {} corners: too many of them are concave to split it; expected triangles",
                       corners);
  return fmt::format("invalid face of {} corners: it intersects itself; expected a simple polygon", corners);
}

class Splitter {
 public:
  explicit Splitter(TriangleSurface& surface) : surface_(surface) {}

  Split add(Corners corners) {
    if (corners.size() == 3) {
      surface_.triangles.push_back({corners[0], corners[1], corners[2]});
      return Split::done;
    }
    x_.clear();
    for (const LocalIndex corner : corners) x_.push_back(nth(surface_.points, corner));
    parts_.clear();
    const Split split = corners.size() == 4 ? split_quadrilateral(std::span<const Vec3, 4>(x_.data(), 4), parts_)
                                            : clipping_.split(x_, parts_);
    const auto corner = [&](LocalIndex position) { return nth(corners, position); };
    for (const auto& [a, b, c] : parts_) surface_.triangles.push_back({corner(a), corner(b), corner(c)});
    return split;
  }

 private:
  TriangleSurface& surface_;
  EarClipping clipping_;
  std::vector<Vec3> x_;
  std::vector<std::array<LocalIndex, 3>> parts_;
};

}  // namespace

void split_polygons(const Polygons& polygons, const FaceWords& words, TriangleSurface& surface) {
  const auto fail = [&](std::size_t face, const std::string& fault) {
    throw InputError(fmt::format("{}: {}", words.where(face, polygons.places[face]), fault));
  };
  constexpr auto most = static_cast<std::size_t>(std::numeric_limits<LocalIndex>::max());
  const std::size_t count = polygons.corners.size() - 2 * polygons.ends.size();
  if (count > most) fail(0, fmt::format("out of range: {} triangles; expected at most {}", count, most));
  surface.triangles.reserve(count);
  Splitter splitter(surface);
  std::vector<LocalIndex> sorted;
  std::size_t begin = 0;
  for (std::size_t face = 0; face < polygons.ends.size(); ++face) {
    const std::size_t end = polygons.ends[face];
    const Corners corners(polygons.corners.data() + begin, end - begin);
    begin = end;
    if (const LocalIndex twice = repeated(corners, sorted); twice != no_index)
      fail(face, fmt::format("invalid face: corner {} is given twice; expected different corners",
                             std::int64_t{twice} + words.first_index));
    if (const Split split = splitter.add(corners); split != Split::done) fail(face, fault_of(split, corners.size()));
  }
}

}  // namespace brunt::io
