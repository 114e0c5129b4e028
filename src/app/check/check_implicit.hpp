// SPDX-License-Identifier: Apache-2.0
// The report of `brunt check` for an implicit scene, in place of stable steps.
#pragma once
#include <string>
#include <vector>

#include "app/state/prepared.hpp"

namespace brunt::app {

/// Solver, interfaces, unknowns, number of steps and their cost, measured in one trial step. Collective.
std::vector<std::string> implicit_check(Prepared& run, const std::string& time_unit);

/// A duration in readable units; `seconds` of wall clock.
std::string duration_text(double seconds);

}  // namespace brunt::app
