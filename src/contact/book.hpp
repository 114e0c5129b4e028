// SPDX-License-Identifier: Apache-2.0
// Records of the last contact step.
#pragma once
#include "contact/contact.hpp"

namespace brunt::contact {

/// Statistics of the solver. can_be_met: all rows have a solution; otherwise no number of iterations would suffice.
void book_iterations(const EnforcementResult& result, const EnforcementSettings& settings, bool can_be_met,
                     ContactStatistics& statistics);

/// Work and impulses, added to the sums over the run.
void book_impulses(Contact& contact);

}  // namespace brunt::contact
