// SPDX-License-Identifier: Apache-2.0
// The unknowns of an implicit step: the displacements of all nodes, three for each node, in the canonical order of the
// mesh.
#pragma once
#include <span>
#include <vector>

#include "comm/communicator.hpp"
#include "comm/halo.hpp"
#include "model/model.hpp"

namespace brunt::implicit {

/// Row 3 gid + c of the whole system is component c of the node with this canonical number; its owner has the row.
struct Unknowns {
  GlobalIndex total = 0;           ///< of all ranks
  std::vector<LocalIndex> node;    ///< nodes this rank owns, ascending
  std::vector<GlobalIndex> row;    ///< three for each of them, ascending
  std::vector<LocalIndex> copy;    ///< nodes of other ranks with a copy on this rank, ascending
  comm::Halo copies;               ///< from the nodes of all ranks to these copies
  std::vector<double> received{};  ///< three for each of `copy`
};

/// Collective.
Unknowns number_unknowns(const comm::Communicator& ranks, const model::Model& model);

/// Updates the copies of nodes with the values of their owners; `nodal`: three for each node of this rank. Collective.
void share(Unknowns& unknowns, std::span<double> nodal);

}  // namespace brunt::implicit
