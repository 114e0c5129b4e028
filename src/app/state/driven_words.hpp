// SPDX-License-Identifier: Apache-2.0
// Words for parts that supports move through each other, or through a rigid wall, in explicit and implicit runs alike.
#pragma once
#include <cstdint>
#include <string>

#include "model/model.hpp"

namespace brunt::app {

/// "part 'a' and rigid wall 'w'". other: a block, or -1 - w for wall w.
std::string driven_pair(const model::Model& model, std::int32_t block, std::int32_t other);

/// "0.01 mm"; length_unit may be empty.
std::string driven_length(double length, const std::string& length_unit);

/// What is said once of a pair of which neither side can yield. since: [time]
std::string driven_through(const model::Model& model, std::int32_t block, std::int32_t other, double since,
                           double depth, const std::string& length_unit);

}  // namespace brunt::app
