// SPDX-License-Identifier: Apache-2.0
// When the lists of contact are rebuilt, and all that is sized with them.
#pragma once
#include "brunt/contact/contact.hpp"

namespace brunt::contact {

/// Lists for the positions and predicted velocities of now. Collective.
void rebuild(Contact& contact, const StepInput& input);

}  // namespace brunt::contact
