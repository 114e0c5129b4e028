// SPDX-License-Identifier: Apache-2.0
// The two-block example of Heinstein et al. 2000, sections 4.2 to 4.4, and the thirteen vectors printed there.
#pragma once
#include <algorithm>
#include <array>
#include <vector>

#include "core/types.hpp"
#include "geometry/box.hpp"

namespace brunt::two_blocks {

/// Two 2 x 2 x 2 blocks of cubes of 0.5 in that touch on y = 1; surface nodes by y, then z downward, then x; the inner
/// node of the layers y = 0.5 and 1.5 is left out.
inline std::vector<Vec3> nodes() {
  std::vector<Vec3> nodes;
  for (const auto& layers : {std::array{0.0, 0.5, 1.0}, std::array{1.0, 1.5, 2.0}})
    for (const double y : layers)
      for (const double z : {1.0, 0.5, 0.0})
        for (const double x : {0.0, 0.5, 1.0})
          if (!(x == 0.5 && z == 0.5 && (y == 0.5 || y == 1.5))) nodes.emplace_back(x, y, z);
  return nodes;
}

/// Master surface 5 has the nodes 18, 19, 22, 21. Its capture box as printed: swept over 1.1e-6 s at 500 in/s in y. (By
/// the definition of Fig. 6 y_max would be 1.0011; the pairs are the same.)
inline geometry::Box capture_box() {
  return {Vec3(0.0, 0.99945, 0.5), Vec3(0.5, 1.00055, 1.0)};
}

/// Numbers as in the paper, from 1, of the points found that are no nodes of the face.
inline std::vector<LocalIndex> partners(const std::vector<LocalIndex>& found) {
  std::vector<LocalIndex> partners;
  for (const LocalIndex p : found)
    if (const LocalIndex node = p + 1; node != 18 && node != 19 && node != 21 && node != 22) partners.push_back(node);
  std::sort(partners.begin(), partners.end());
  return partners;
}

/// From places and numbers that count from 0 to those of the paper.
inline std::vector<LocalIndex> from_one(std::vector<LocalIndex> numbers) {
  for (LocalIndex& number : numbers) ++number;
  return numbers;
}

inline const std::vector<LocalIndex> lbox{31, 32, 33, 16, 17, 18, 1,  2,  3,  34, 35, 36, 19, 21, 4,  5, 6, 37,
                                          38, 39, 22, 23, 24, 7,  8,  9,  37, 38, 39, 22, 23, 24, 7,  8, 9, 40,
                                          41, 42, 25, 27, 10, 11, 12, 43, 44, 45, 28, 29, 30, 13, 14, 15};
inline const std::vector<LocalIndex> nbox{1, 1, 1, 1, 1, 1, 2, 2, 2, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 0, 1, 2, 2,
                                          2, 1, 0, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 2, 2, 2, 1, 1, 1, 1, 1, 1};
inline const std::vector<LocalIndex> npoint{1,  2,  3,  4,  5,  6,  7,  9,  11, 13, 14, 15, 16, 17, 18,
                                            19, 20, 21, 22, 23, 23, 24, 26, 28, 30, 31, 31, 32, 33, 34,
                                            35, 36, 37, 38, 39, 40, 41, 43, 45, 47, 48, 49, 50, 51, 52};
inline const std::vector<LocalIndex> ndsort{7, 8,  9,  15, 16, 17, 24, 33, 25, 34, 26, 35, 41, 42, 43, 50, 51, 52,
                                            4, 5,  6,  13, 14, 21, 30, 22, 31, 23, 32, 39, 40, 47, 48, 49, 1,  2,
                                            3, 10, 11, 12, 18, 27, 19, 28, 20, 29, 36, 37, 38, 44, 45, 46};
inline const std::vector<LocalIndex> i_x{1, 4,  7,  10, 13, 15, 18, 21, 24, 27, 30, 33, 36, 39, 41, 44, 47, 50,
                                         2, 5,  8,  11, 16, 19, 22, 25, 28, 31, 34, 37, 42, 45, 48, 51, 3,  6,
                                         9, 12, 14, 17, 20, 23, 26, 29, 32, 35, 38, 40, 43, 46, 49, 52};
inline const std::vector<LocalIndex> i_y{1,  2,  3,  4,  5,  6,  7,  8,  9,  10, 11, 12, 13, 14, 15, 16, 17, 18,
                                         19, 20, 21, 22, 23, 24, 25, 26, 27, 28, 29, 30, 31, 32, 33, 34, 35, 36,
                                         37, 38, 39, 40, 41, 42, 43, 44, 45, 46, 47, 48, 49, 50, 51, 52};
inline const std::vector<LocalIndex> i_z{7, 8,  9,  15, 16, 17, 24, 25, 26, 33, 34, 35, 41, 42, 43, 50, 51, 52,
                                         4, 5,  6,  13, 14, 21, 22, 23, 30, 31, 32, 39, 40, 47, 48, 49, 1,  2,
                                         3, 10, 11, 12, 18, 19, 20, 27, 28, 29, 36, 37, 38, 44, 45, 46};
inline const std::vector<LocalIndex> r_x{1,  19, 35, 2,  20, 36, 3,  21, 37, 4,  22, 38, 5,  39, 6,  23, 40, 7,
                                         24, 41, 8,  25, 42, 9,  26, 43, 10, 27, 44, 11, 28, 45, 12, 29, 46, 13,
                                         30, 47, 14, 48, 15, 31, 49, 16, 32, 50, 17, 33, 51, 18, 34, 52};
inline const std::vector<LocalIndex> r_y{1,  2,  3,  4,  5,  6,  7,  8,  9,  10, 11, 12, 13, 14, 15, 16, 17, 18,
                                         19, 20, 21, 22, 23, 24, 25, 26, 27, 28, 29, 30, 31, 32, 33, 34, 35, 36,
                                         37, 38, 39, 40, 41, 42, 43, 44, 45, 46, 47, 48, 49, 50, 51, 52};
inline const std::vector<LocalIndex> r_z{35, 36, 37, 19, 20, 21, 1,  2,  3,  38, 39, 40, 22, 23, 4,  5,  6,  41,
                                         42, 43, 24, 25, 26, 7,  8,  9,  44, 45, 46, 27, 28, 29, 10, 11, 12, 47,
                                         48, 49, 30, 31, 13, 14, 15, 50, 51, 52, 32, 33, 34, 16, 17, 18};
inline const std::vector<LocalIndex> l_x{1,  4, 7, 10, 13, 15, 18, 21, 24, 27, 30, 33, 36, 39, 41, 44, 47,
                                         50, 2, 5, 8,  11, 16, 19, 22, 25, 28, 31, 34, 37, 42, 45, 48, 51};
inline const std::vector<LocalIndex> l_y{18, 19, 20, 21, 22, 23, 24, 25, 26, 27, 28, 29, 30, 31, 32, 33, 34, 35};
inline const std::vector<LocalIndex> l_z{4, 5, 6,  13, 14, 21, 22, 23, 30, 31, 32, 39, 40, 47, 48, 49, 1,
                                         2, 3, 10, 11, 12, 18, 19, 20, 27, 28, 29, 36, 37, 38, 44, 45, 46};

}  // namespace brunt::two_blocks
