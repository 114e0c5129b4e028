// SPDX-License-Identifier: Apache-2.0
// What `brunt check` tells of an implicit scene in place of stable steps.
#pragma once
#include <string>
#include <vector>

#include "prepare.hpp"

namespace brunt::app {

/// Solver, interfaces, unknowns, number of steps and what they will cost, from one step that is tried. Collective.
std::vector<std::string> implicit_check(Prepared& run, const std::string& time_unit);

/// A duration as a user reads it; `seconds` of wall clock.
std::string duration_text(double seconds);

}  // namespace brunt::app
