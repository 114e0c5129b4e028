// SPDX-License-Identifier: Apache-2.0
// Value of a scene's piecewise-linear curve at a time: the same function that runs use.
#pragma once
#include "brunt/model/curve.hpp"

namespace brunt::scene {

using model::value_at;

}  // namespace brunt::scene
