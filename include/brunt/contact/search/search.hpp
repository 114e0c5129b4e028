// SPDX-License-Identifier: Apache-2.0
// Which points lie in which boxes, on one rank. No physics, no messages.
#pragma once
#include <span>

#include "brunt/core/ragged.hpp"
#include "brunt/core/types.hpp"
#include "brunt/geometry/box.hpp"

namespace brunt::contact {

/// pairs row b: the points inside the closed box b, ascending. Points with a coordinate that is not finite are in no
/// box. Binary sort of Heinstein et al. 2000, section 4.4: the points are sorted along each axis, two bisections an
/// axis bound the candidates of a box, and those of the axis with the fewest are tested by their ranks along the other
/// two. O(n log n) to sort; a box costs 6 log n and its shortest list.
void find_pairs(std::span<const geometry::Box> boxes, std::span<const Vec3> points, Ragged<LocalIndex>& pairs);

}  // namespace brunt::contact
