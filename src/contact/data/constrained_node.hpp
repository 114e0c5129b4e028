// SPDX-License-Identifier: Apache-2.0
// A node that supports hold.
#pragma once
#include "core/types.hpp"

namespace brunt::contact {

/// A node of the mesh with constrained directions.
struct ConstrainedNode {
  LocalIndex node = 0;
  Mat3 free = Mat3::Identity();  ///< projector onto the free directions
};

}  // namespace brunt::contact
