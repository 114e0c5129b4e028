// SPDX-License-Identifier: Apache-2.0
// What rows are given besides what detection finds: their passes, friction, and the slabs of the printed method; and
// what of them is remembered.
#pragma once
#include "brunt/contact/contact.hpp"

namespace brunt::contact {

/// Completes step.rows.
void assemble_rows(Contact& contact, const StepInput& input);

/// The history after the step.
void remember(Contact& contact, const StepInput& input);

}  // namespace brunt::contact
