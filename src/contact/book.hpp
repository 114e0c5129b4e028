// SPDX-License-Identifier: Apache-2.0
// What contact books of its last step.
#pragma once
#include "brunt/contact/contact.hpp"

namespace brunt::contact {

/// How much there was to solve.
void book_iterations(const EnforcementResult& result, const EnforcementSettings& settings,
                     ContactStatistics& statistics);

/// Work and impulses, into the sums over the run.
void book_impulses(Contact& contact);

}  // namespace brunt::contact
