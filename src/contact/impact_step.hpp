// SPDX-License-Identifier: Apache-2.0
// Return at opening in a step of contact (Impact::elastic): which rows take part, their state from and to the history.
#pragma once
#include "contact/contact.hpp"

namespace brunt::contact {

/// Before the first solution of the step: its initial impulses, and the flow around contact nodes. Collective.
void begin_impacts(Contact& contact, const StepInput& input);

/// After it: rows that open return what they took, and the history has the states of the others. system: of
/// step.scratch.enforcement.matrix. Collective.
void return_energy(Contact& contact, const StepInput& input, const System& system, EnforcementResult& result);

}  // namespace brunt::contact
