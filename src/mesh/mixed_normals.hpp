// SPDX-License-Identifier: Apache-2.0
// Shells of one block whose normals point to different sides.
#pragma once
#include <cstdint>

#include "mesh/mesh.hpp"

namespace brunt::mesh {

/// Edges of exactly two shells that both run along it in the same direction: across them top and bottom change places.
/// Edges where three shells or more meet are not counted, since their normals have no order.
struct MixedNormals {
  std::int64_t count = 0;
  LocalIndex first = 0, second = 0;  ///< the elements of the first such edge
};
[[nodiscard]] MixedNormals mixed_normals(const Block& block);

}  // namespace brunt::mesh
