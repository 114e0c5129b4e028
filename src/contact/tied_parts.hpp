// SPDX-License-Identifier: Apache-2.0
// Ties of a run: found once at the start, on the rank of their slaves, and rows of every step.
#pragma once
#include "brunt/contact/contact.hpp"

namespace brunt::contact {

/// From lists and positions of contact nodes at the start.
TiedParts find_tied_parts(const Contact& contact);

/// Drops the ties of which the face has gone, or all of the slave's elements in the part that is tied. faces: that are
/// left on this rank, ascending by key; contact.surface is theirs already. Collective.
void release_ties(Contact& contact, std::span<const mesh::ExteriorFace> faces);

/// Asked of new lists on all ranks, so that all stop: throws GuardError where tied parts have been torn from each
/// other. Collective.
void demand_ties_hold(const Contact& contact);

/// A tied node has nothing but its tie to do with that body, nor have edges of tied parts with each other.
void drop_tied_rows(const Contact& contact, std::vector<Row>& rows);

/// A row a tie.
void append_tie_rows(Contact& contact, const Carriers& carriers, double dt, std::vector<Row>& rows);

}  // namespace brunt::contact
