// SPDX-License-Identifier: Apache-2.0
// Vectors of a node as four doubles: x, y, z and one without meaning.
#pragma once
#include <cstring>

#include "contact/data/constraint.hpp"
#include "core/simd.hpp"

namespace brunt::contact {

BRUNT_INLINE Quad position_quad(const NodeMotion& node) {
  Quad four;
  std::memcpy(&four, reinterpret_cast<const char*>(&node), sizeof four);  // the fourth belongs to the old velocity
  return four;
}

BRUNT_INLINE Quad predicted_quad(const NodeMotion& node) {
  Quad four;
  std::memcpy(&four, reinterpret_cast<const char*>(&node) + sizeof(NodeMotion) - sizeof four, sizeof four);
  return __builtin_shufflevector(four, four, 1, 2, 3, 0);
}

}  // namespace brunt::contact
