// SPDX-License-Identifier: Apache-2.0
// What is said of implicit scenes in which supports drive bodies where contact and ties cannot act.
#pragma once
#include <string>
#include <vector>

#include "prepare.hpp"

namespace brunt::app {

/// Before the run: throws InputError where supports drive the two sides of a tie apart, by their curves up to the end.
/// Collective.
void refuse_driven_apart(Prepared& run);

/// After a step: throws GuardError where supports or walls drive the two sides of a tie apart. Collective.
void stop_where_driven_apart(Prepared& run);

/// Warnings of bodies that supports drive through each other or through walls, each once. Collective.
std::vector<std::string> watch_driven_through(Prepared& run);

}  // namespace brunt::app
