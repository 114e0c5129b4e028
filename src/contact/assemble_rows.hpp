// SPDX-License-Identifier: Apache-2.0
// Properties of rows that detection does not set: their passes, friction, and the slabs of the printed method; and the
// history of rows.
#pragma once
#include "contact/contact.hpp"

namespace brunt::contact {

/// Completes step.rows.
void assemble_rows(Contact& contact, const StepInput& input);

/// The history after the step.
void remember(Contact& contact, const StepInput& input);

}  // namespace brunt::contact
