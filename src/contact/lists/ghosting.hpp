// SPDX-License-Identifier: Apache-2.0
// Distribution of surface data: the owner of a slave needs every face and edge that may touch it. Ranks report the
// cells of a sparse grid that their boxes occupy to the home rank of each cell, and the home ranks report back which
// ranks need which faces. No array has the size of the grid, so far outliers have no cost. A box occupies cells of its
// own size and, if the other side has larger ones, those; it occupies at most eight cells on each level.
#pragma once
#include <algorithm>
#include <array>
#include <span>
#include <vector>

#include "comm/communicator.hpp"
#include "comm/rendezvous.hpp"
#include "contact/surface/surface.hpp"
#include "core/cells.hpp"
#include "geometry/box.hpp"

namespace brunt::contact {

/// A box that can be sent.
struct PlainBox {
  std::array<double, 3> low{}, high{};

  PlainBox() = default;
  explicit PlainBox(const geometry::Box& box)
      : low{box.low[0], box.low[1], box.low[2]}, high{box.high[0], box.high[1], box.high[2]} {}
  [[nodiscard]] geometry::Box box() const { return {Vec3(low.data()), Vec3(high.data())}; }
};

/// A face with all data needed for the search and for finding the owners of its nodes.
struct GhostFace {
  GlobalIndex key = 0;
  std::array<GlobalIndex, 4> gid{};
  std::array<Place, 4> home{};
  std::int32_t corner_count = 0, body = 0, block = 0;
  PlainBox capture{};                                      ///< capture box
  double element_depth = 0;                                ///< of its element
  std::uint8_t seams = 0;                                  ///< as of the surface's face
  std::array<GlobalIndex, cells::most_corners> element{};  ///< nodes of its element, no_index to fill

  friend bool operator<(const GhostFace& a, const GhostFace& b) { return a.key < b.key; }
};

/// The same for a convex edge.
struct GhostEdge {
  std::array<GlobalIndex, 2> gid{};  ///< ascending
  std::array<Place, 2> home{}, facets{};
  std::array<GlobalIndex, 2 * cells::most_corners> elements{};
  double element_depth = 0;  ///< of its elements
  std::int32_t body = 0, block = 0;
  EdgeKind kind = EdgeKind::sharp;
  std::array<bool, 2> seam{};
  std::array<char, 2> end_on_rim{};  ///< 1: that end stands on a sharp edge
  std::array<std::array<bool, 2>, 2> end_at_side{};
  PlainBox capture{};  ///< capture box

  friend bool operator<(const GhostEdge& a, const GhostEdge& b) { return a.gid < b.gid; }
};

/// Edge of the smallest cells [length] if only the boxes are known: that of the smallest box of all ranks that has a
/// size. Collective.
double finest_cell(const comm::Communicator& ranks, std::span<const geometry::Box> boxes);

/// Row r: which of this rank's `offered` boxes share a cell with a `wanted` box of rank r, ascending; none for this
/// rank itself. finest: edge of the smallest cells [length], the same on all ranks. Collective.
std::vector<std::vector<LocalIndex>> meet_in_cells(const comm::Communicator& ranks,
                                                   std::span<const geometry::Box> offered,
                                                   std::span<const geometry::Box> wanted, double finest);

/// Faces and edges of other ranks that may touch a `wanted` box, in ascending order. Collective.
template <class Ghost>
std::vector<Ghost> ghost(const comm::Communicator& ranks, std::span<const Ghost> offered,
                         std::span<const geometry::Box> wanted, double finest) {
  std::vector<geometry::Box> boxes;
  boxes.reserve(offered.size());
  for (const Ghost& candidate : offered) boxes.push_back(candidate.capture.box());
  std::vector<std::vector<Ghost>> outgoing;
  for (const std::vector<LocalIndex>& leaving : meet_in_cells(ranks, boxes, wanted, finest)) {
    outgoing.emplace_back();
    for (const LocalIndex i : leaving) outgoing.back().push_back(nth(offered, i));
  }
  std::vector<Ghost> ghosts = comm::exchange(ranks, outgoing).values;
  std::sort(ghosts.begin(), ghosts.end());
  return ghosts;
}

}  // namespace brunt::contact
