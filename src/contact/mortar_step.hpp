// SPDX-License-Identifier: Apache-2.0
// Mortar rows in a step of contact over the ranks: kept weights, their rows, and the rows of nodes and edges that they
// replace, so that no place has both.
#pragma once
#include "contact/contact.hpp"

namespace brunt::contact {

/// Nodes of kept rows, ascending: lists must have them.
std::vector<GlobalIndex> nodes_of_kept_rows(const MortarHistory& history);

/// Where the terms of kept rows are in new lists.
void place_kept_rows(Contact& contact);

/// Renews weights, and notes which nodes have mortar rows with which bodies. Collective.
void renew_mortar_rows(Contact& contact);

/// Appends mortar rows, and removes the rows of nodes on faces that they replace.
void exchange_face_rows(Contact& contact, const StepView& view);

/// Removes rows of edges [first .. end) of which one edge lies within what mortar rows hold.
void drop_held_edges(const Contact& contact, std::size_t first, std::vector<Row>& rows);

/// What the row's function covers [length^2].
double area_of_mortar_row(const Contact& contact, const Row& row);

}  // namespace brunt::contact
