// SPDX-License-Identifier: Apache-2.0
// The dense parts of the matrix from slave facets and rows, summed by the owners of its rows in one order: by
// interface, then facets by their keys, then rows by their nodes.
#pragma once
#include <functional>
#include <vector>

#include "contact/mortar/tractions.hpp"
#include "implicit/mortar/mortar.hpp"

namespace brunt::implicit {

/// Receives dF_row/dx_column: row is a place in ContactNodes that this rank owns, column the number of a node.
using TakeBlock = std::function<void(LocalIndex row, GlobalIndex column, const Mat3& slope)>;

/// Patches of MortarSlopes::weights, and weights times derivatives of tractions (one entry for each interface; empty
/// for ties). Collective.
void sum_pieces(const comm::Communicator& ranks, const MortarContact& contact,
                const std::vector<contact::TractionSlopes>& tractions, const TakeBlock& take);

}  // namespace brunt::implicit
