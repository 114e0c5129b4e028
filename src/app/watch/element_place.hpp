// SPDX-License-Identifier: Apache-2.0
// The element or node of a message: number, part, position, compression. All calls are collective, and name the same
// one on any number of ranks.
#pragma once
#include <string>

#include "app/state/prepared.hpp"

namespace brunt::app {

struct ElementPlace {
  GlobalIndex element = -1;  ///< position in the input; -1: there is none
  std::int32_t block = -1;   ///< of the model; -1: there is none
  std::string part;
  Vec3 center = Vec3::Zero();  ///< mean of its nodes, at x_n
  double shortest_edge = 1;    ///< over that of the reference
  double volume = 1;           ///< over that of the reference
};

/// For the element that this rank names (block -1: none), the one with the largest position in the input.
ElementPlace place_of(const Prepared& run, std::int32_t block, LocalIndex element);

/// The element whose history field of this name is least.
ElementPlace place_of_least(const Prepared& run, const std::string& field);

/// "element 17 (position in the input) of part 'a' at (0, 0.1, 0.2)".
std::string text_of(const ElementPlace& place);

/// "part a, node 17", the number in the input.
std::string name_of_node(const Prepared& run, GlobalIndex gid);

/// A place, the mesh's origin put back.
std::string text_of_point(const Prepared& run, const Vec3& position);

}  // namespace brunt::app
