// SPDX-License-Identifier: Apache-2.0
// The velocity with which a driven direction begins a run.
#pragma once
#include "model/model.hpp"

namespace brunt::time {

/// Speeds that differ by less than this share are equal: numbers of a scene are written with seven digits, and a
/// rotation leaves rounding where it gives no speed.
constexpr double same_speed = 1e-6;

/// A direction that `initial` moves has its prescribed velocity already at t = 0 (of a displacement: the slope of its
/// curve), so that nothing has to push it there; an acceleration changes the initial velocity itself. One at rest
/// (initial = 0) is brought to its velocity by an impulse in the first step, whose work is in the balance.
[[nodiscard]] double driven_start(const model::Drive& drive, double initial);

}  // namespace brunt::time
