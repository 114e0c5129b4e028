// SPDX-License-Identifier: Apache-2.0
// Value of a piecewise linear curve of the scene at a time; the same function is used during runs.
#pragma once
#include "model/curve.hpp"

namespace brunt::scene {

using model::value_at;

}  // namespace brunt::scene
