// SPDX-License-Identifier: Apache-2.0
// The chains of rigid bodies that soft rows form, and the factor of the compliance in each pair of bodies
// (enforcement/softness.hpp). Pairs are edges of a graph of bodies, those with what is immovable lead to the ground. A
// load passes a pair from one side to the other: sides are the bodies connected with each of the two when the pair is
// taken away. A side is free if it has no other way to the ground; a light body on top of a heavy one is a free side
// that carries itself only, one below it is not. With h the least answer of the bodies of a side, the factor is
//   k (h_1 + h_2) / (A_1 + A_2) for two free sides, 2 k h_free / (A_1 + A_2) for one, 2 k min(h_1, h_2) / (A_1 + A_2)
// for none, k h / A with the ground, and at most 1, with k = chain_share.
// Where a pair is no bridge of the graph both sides are the whole chain.
#pragma once
#include "contact/enforcement/system.hpp"

namespace brunt::contact {

/// Masses of a chain may differ by this factor before its compliance follows the heavy ones: see "Numbers that decide"
/// in the README.
constexpr double chain_share = 20;

/// A soft row whose points all belong to bodies or are immovable.
bool is_between_bodies(const System& system, std::size_t q);

/// The pair of such a row; negative: none of its bodies moves along it.
double pair_of(const System& system, std::size_t q);

/// To be called first, before start_bodies: pairs and answers of this rank's rows.
void note_pairs(const System& system, ChainScratch& chains);

/// Of the pairs of all ranks: chain of each body, and factor of each pair. Collective.
void find_chains(std::size_t bodies, Exchange& exchange, ChainScratch& chains);

}  // namespace brunt::contact
