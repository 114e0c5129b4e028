// SPDX-License-Identifier: Apache-2.0
// Contact search: which points lie in which boxes, over the ranks of a communicator (Heinstein et al. 2000, section 4).
#pragma once
#include <mpi.h>

#include <cstdint>
#include <span>
#include <vector>

namespace brunt::api {

/// How the pairs of one rank are found; all methods find the same ones.
enum class SearchMethod : std::int8_t {
  blocks,  ///< blocks of points along a space-filling curve below a tree of boxes: what `brunt run` does
  binary,  ///< the paper's bisection of lists sorted along the axes
  bucket   ///< the paper's sort into buckets
};

/// In compressed rows: the boxes of point p of this rank are box[first[p]] ... box[first[p + 1] - 1], in ascending
/// order.
struct PointsInBoxes {
  std::vector<std::int64_t> first;  ///< number of points + 1
  std::vector<std::int64_t> box;    ///< numbers of boxes over all ranks
};

/// points: x, y, z of each point of this rank [length]. boxes: low x, y, z and high x, y, z of each box of this rank
/// [length]. Boxes are numbered over the ranks: those of rank 0 from 0, then those of rank 1. They are closed; one with
/// low > high or a NaN contains nothing, a point with a coordinate that is not finite is in none. Collective.
PointsInBoxes find_points_in_boxes(MPI_Comm ranks, std::span<const double> points, std::span<const double> boxes,
                                   SearchMethod method = SearchMethod::blocks);

}  // namespace brunt::api
