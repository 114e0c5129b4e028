// SPDX-License-Identifier: Apache-2.0
// Which faces go to which rank: each slave node's owner must see every face that could touch it. Ranks say which
// cells of a sparse grid their faces and their slave nodes fill; cells meet at a home rank, which tells the ranks of
// the faces who needs them. No array has the size of the grid, so a far outlier costs nothing; boxes much larger than
// the finest cell use coarser grids, so none fills more than eight cells.
#pragma once
#include <array>
#include <span>
#include <vector>

#include "brunt/comm/communicator.hpp"
#include "brunt/contact/surface/surface.hpp"
#include "brunt/geometry/box.hpp"

namespace brunt::contact {

/// A face with all that is needed to search it and to find its nodes' owners.
struct TravellingFace {
  GlobalIndex key = 0;
  std::array<GlobalIndex, 4> gid{};
  std::array<Place, 4> home{};
  std::int32_t corner_count = 0, body = 0, block = 0;
  std::array<double, 3> low{}, high{};  ///< capture box
  double depth = 0;                     ///< of its element

  [[nodiscard]] geometry::Box box() const { return {Vec3(low.data()), Vec3(high.data())}; }
};

/// Faces of other ranks that share a cell with one of `points`, in ascending key. faces: those of this rank, with
/// capture boxes that already hold the motion allowed. finest: edge of the smallest cells [length], the same on all
/// ranks. Collective.
std::vector<TravellingFace> ghost_faces(const comm::Communicator& ranks, std::span<const TravellingFace> faces,
                                        std::span<const Vec3> points, double finest);

}  // namespace brunt::contact
