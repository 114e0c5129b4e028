// SPDX-License-Identifier: Apache-2.0
// Prescribed motion of a drive over one step.
#pragma once
#include "model/model.hpp"

namespace brunt::implicit {

struct Given {
  double travel = 0, velocity = 0;  ///< over the step, at its end: [length] or [rad]
};

/// From t_n to t_{n+1}, exact for curves that are linear within the step. The velocity of a prescribed displacement is
/// its mean over the step.
Given driven(const model::Drive& drive, double velocity_before, double from, double to);

}  // namespace brunt::implicit
