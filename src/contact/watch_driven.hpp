// SPDX-License-Identifier: Apache-2.0
// Maintains the list of pairs that supports move through each other.
#pragma once
#include "contact/contact.hpp"

namespace brunt::contact {

/// Examines the rows of the step, after `find_unmet_rows`. Collective where rigid bodies may be driven.
void watch_driven(Contact& contact, const StepInput& input);

}  // namespace brunt::contact
