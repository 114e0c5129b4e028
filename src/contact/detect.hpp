// SPDX-License-Identifier: Apache-2.0
// The rows of a step from the candidate lists, and whether any candidates can touch at all.
#pragma once
#include "contact/contact.hpp"

namespace brunt::contact {

/// No candidates, or too far apart for the motion since the lists were created; the same on every rank.
bool nothing_can_meet(const Contact& contact);

/// Fills step.rows, in the order of their keys: faces, edges, walls, ties. Measures the separation of new lists, and
/// notes what supports drive through others. Collective.
void detect_rows(Contact& contact, const StepInput& input);

/// Rows alone: what detect_rows begins with. Collective.
void find_rows(Contact& contact, const StepInput& input);

}  // namespace brunt::contact
