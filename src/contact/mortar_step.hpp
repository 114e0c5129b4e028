// SPDX-License-Identifier: Apache-2.0
// Mortar rows in a step of contact over the ranks: kept weights, their rows, and the rows of nodes and edges that they
// replace, so that no place has both.
#pragma once
#include "contact/contact.hpp"

namespace brunt::contact {

/// Nodes of kept rows, ascending: lists must have them.
std::vector<GlobalIndex> nodes_of_kept_rows(const MortarHistory& history);

/// Forgets the kept rows with a node of a face that has gone or come since that surface. Collective.
void forget_changed_rows(const Surface& before, Contact& contact);

/// Where the terms of kept rows are in new lists.
void place_kept_rows(Contact& contact);

/// Renews weights, and notes which nodes have mortar rows with which bodies. Collective.
void renew_mortar_rows(Contact& contact);

/// Appends mortar rows, and removes the rows of nodes on faces that they replace.
void exchange_face_rows(Contact& contact, const StepView& view);

/// What the row's function covers [length^2].
double area_of_mortar_row(const Contact& contact, const Row& row);

}  // namespace brunt::contact
