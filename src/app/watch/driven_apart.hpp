// SPDX-License-Identifier: Apache-2.0
// Messages about implicit scenes in which supports prescribe motions against contact and ties.
#pragma once
#include <string>
#include <vector>

#include "app/state/prepared.hpp"

namespace brunt::app {

/// Before the run: throws InputError if supports separate the two sides of a tie, by their curves up to the end.
/// Collective.
void refuse_driven_apart(Prepared& run);

/// After a step: throws GuardError if supports or walls separate the two sides of a tie. Collective.
void stop_where_driven_apart(Prepared& run);

/// Warnings of bodies that supports move through each other or through walls, each once. Collective.
std::vector<std::string> watch_driven_through(Prepared& run);

}  // namespace brunt::app
