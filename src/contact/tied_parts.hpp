// SPDX-License-Identifier: Apache-2.0
// Ties of a run over the ranks: found at the start, on the rank of their slaves; integrated again from the geometry of
// the start when elements are gone; rows of every step.
#pragma once
#include "contact/contact.hpp"

namespace brunt::contact {

/// From lists and positions of contact nodes at the start. Collective.
TiedParts find_tied_parts(Contact& contact);

/// The block of the slave (contact node) that is tied to this one, the first of several; no_index where none is.
std::int32_t tied_block(const Contact& contact, LocalIndex slave, std::int32_t master_block);

/// Removes the pins whose face was removed, or whose slave has lost all elements in the tied part. faces: remaining on
/// this rank, ascending by key; contact.surface already refers to them. Collective.
void release_ties(Contact& contact, std::span<const mesh::ExteriorFace> faces);

/// Checks new lists on all ranks, so that all stop: throws GuardError if a tie is broken. positions: of contact nodes.
/// Collective.
void demand_ties_hold(const Contact& contact, std::span<const Vec3> positions);

/// A tied node has no contact with that body other than its tie, nor do edges of tied parts have contact with each
/// other.
void drop_tied_rows(const Contact& contact, std::vector<Row>& rows);

/// A row a tie.
void append_tie_rows(Contact& contact, const Carriers& carriers, double dt, std::vector<Row>& rows);

/// From lists and positions of contact nodes at the start; pairs: those that may share segments, ascending, or all.
/// Collective.
MortarTies find_mortar_ties(Contact& contact, const std::vector<TiedPair>* pairs);

/// Where the terms are in new lists.
void place_mortar_ties(Contact& contact);

/// The keys that some rank still has among its faces, ascending. faces: ascending by key. Collective.
std::vector<GlobalIndex> keys_left(const comm::Communicator& ranks, std::vector<GlobalIndex> keys,
                                   std::span<const mesh::ExteriorFace> faces);

/// Pairs of the start of which both faces are left. Collective.
std::vector<TiedPair> pairs_left(const Contact& contact, std::span<const mesh::ExteriorFace> faces);

}  // namespace brunt::contact
