// SPDX-License-Identifier: Apache-2.0
// Keeps the list of pairs that supports drive through each other.
#pragma once
#include "brunt/contact/contact.hpp"

namespace brunt::contact {

/// Looks through the rows of the step.
void watch_driven(Contact& contact, const Carriers& carriers, double dt);

}  // namespace brunt::contact
