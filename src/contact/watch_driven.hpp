// SPDX-License-Identifier: Apache-2.0
// Maintains the list of pairs that supports move through each other.
#pragma once
#include "brunt/contact/contact.hpp"

namespace brunt::contact {

/// Examines the rows of the step.
void watch_driven(Contact& contact, const Carriers& carriers, double dt);

}  // namespace brunt::contact
