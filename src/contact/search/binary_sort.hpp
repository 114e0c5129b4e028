// SPDX-License-Identifier: Apache-2.0
// The binary sort of Heinstein et al. 2000, section 4.4, as printed; a reference for the search in use (search.hpp).
#pragma once
#include <array>
#include <span>
#include <vector>

#include "core/ragged.hpp"
#include "core/types.hpp"
#include "geometry/box.hpp"

namespace brunt::contact {

/// The six vectors of the paper, one of each an axis; with a list of candidates 7 n places. Indices count from 0.
struct BinarySort {
  std::array<std::vector<LocalIndex>, 3> index;  ///< I: finite points by coordinate, equal ones by number
  std::array<std::vector<LocalIndex>, 3> rank;   ///< R: place of each point in I
};

void sort_along_axes(std::span<const Vec3> points, BinarySort& sorted);

/// Places [first, last) of an index vector.
struct PlaceRange {
  LocalIndex first = 0, last = 0;
  [[nodiscard]] LocalIndex size() const { return last - first; }
  [[nodiscard]] bool holds(LocalIndex place) const { return first <= place && place < last; }
};

/// Two bisections an axis: the points between the sides of the box (i_min and i_max of the paper).
std::array<PlaceRange, 3> places_between(const BinarySort& sorted, std::span<const Vec3> points,
                                         const geometry::Box& box);

/// Contraction: of the shortest of the three lists those points whose ranks on the other axes are between the bounds.
void append_points_in_box(const BinarySort& sorted, std::span<const Vec3> points, const geometry::Box& box,
                          std::vector<LocalIndex>& found);

/// pairs row p: the boxes that contain point p, ascending, as in find_pairs (search.hpp). The cost of a box is 6 log n
/// plus its shortest list, whose length is n^(1/2) on surfaces and n^(2/3) in volumes.
void find_pairs_by_bisection(const BinarySort& sorted, std::span<const geometry::Box> boxes,
                             std::span<const Vec3> points, Ragged<LocalIndex>& pairs);

}  // namespace brunt::contact
