// SPDX-License-Identifier: Apache-2.0
// Joints at the start of a run: what initial velocities and the joints themselves contradict.
#pragma once
#include <vector>

#include "model/model.hpp"

namespace brunt::time {

/// A joint that the initial velocities open.
struct OpenedJoint {
  std::size_t joint = 0;
  double rate = 0;   ///< largest rate of a row; that of an axis times the size of its bodies [velocity]
  double speed = 0;  ///< largest of the bodies about the point [velocity]
};

/// Joints and supports of points whose rates at the start exceed `same_speed` of the speeds of their bodies. Driven
/// rows have none: the first step brings them to their velocity.
[[nodiscard]] std::vector<OpenedJoint> joints_opened(const model::Model& model, const model::State& state);

/// Rows of all joints that other rows, or supports, determine at the start; their impulses are shared evenly.
[[nodiscard]] LocalIndex redundant_rows(const model::Model& model, const model::State& state);

}  // namespace brunt::time
