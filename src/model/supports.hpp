// SPDX-License-Identifier: Apache-2.0
// What holds and drives nodes: constant during a run.
#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "contact/data/constrained_node.hpp"
#include "model/curve.hpp"

namespace brunt::model {

/// A prescribed motion, of nodes or of rigid bodies.
struct Drive {
  Curve curve;
  double scale = 1;
  enum class Gives { velocity, displacement, acceleration } gives = Gives::velocity;
};

/// Velocity of a constrained node: free * v + what its drives give.
struct Supports {
  std::vector<contact::ConstrainedNode> nodes;     ///< ascending
  std::vector<std::array<std::int32_t, 3>> drive;  ///< of each of `nodes`, for x, y, z: index into `drives`, or -1
  std::vector<Drive> drives;
  bool any = false;  ///< constrained nodes, on any rank
};

}  // namespace brunt::model
