// SPDX-License-Identifier: Apache-2.0
// Records of the last contact step.
#pragma once
#include "brunt/contact/contact.hpp"

namespace brunt::contact {

/// Statistics of the solver.
void book_iterations(const EnforcementResult& result, const EnforcementSettings& settings,
                     ContactStatistics& statistics);

/// Work and impulses, added to the sums over the run.
void book_impulses(Contact& contact);

}  // namespace brunt::contact
