// SPDX-License-Identifier: Apache-2.0
// Ties with integrated weights over the ranks: integration at the start, and again from the start's geometry when
// elements are gone.
#pragma once
#include "contact/contact.hpp"

namespace brunt::contact {

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
