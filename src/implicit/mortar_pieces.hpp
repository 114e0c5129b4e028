// SPDX-License-Identifier: Apache-2.0
// The dense parts that slave facets and rows add to the matrix, added up by the owners of its rows in one order: by
// interface, then facets by their keys, then rows by their nodes.
#pragma once
#include <functional>
#include <vector>

#include "brunt/contact/mortar/tractions.hpp"
#include "brunt/implicit/mortar.hpp"

namespace brunt::implicit {

/// Takes dF_row/dx_column: row a place in ContactNodes that this rank owns, column the number of a node.
using TakeBlock = std::function<void(LocalIndex row, GlobalIndex column, const Mat3& slope)>;

/// Patches of MortarSlopes::weights, and weights times slopes of tractions (an entry an interface; of ties empty).
/// Collective.
void sum_pieces(const comm::Communicator& ranks, const MortarContact& contact,
                const std::vector<contact::TractionSlopes>& tractions, const TakeBlock& take);

}  // namespace brunt::implicit
