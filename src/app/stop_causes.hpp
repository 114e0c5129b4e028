// SPDX-License-Identifier: Apache-2.0
// What a user is told of why a run cannot go on.
#pragma once
#include <string>

#include "element_place.hpp"
#include "prepare.hpp"

namespace brunt::app {

/// Why the stable step of this element has fallen.
const char* cause_of_collapse(const ElementPlace& place);

/// Why an element of this block may have lost its volume; empty: nothing is known.
const char* cause_of_lost_volume(const model::ElementBlock& block);

std::string not_at_rest(const model::Relaxation& phase, const scene::Relaxation& asked);

}  // namespace brunt::app
