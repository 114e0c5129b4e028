// SPDX-License-Identifier: Apache-2.0
// Rebuilding of the contact lists, and of all arrays whose sizes depend on them.
#pragma once
#include "contact/contact.hpp"

namespace brunt::contact {

/// Lists for the present positions and predicted velocities. facets: of which pairs segments are wanted. Collective.
void rebuild(Contact& contact, const StepInput& input, FacetPairs facets);

}  // namespace brunt::contact
