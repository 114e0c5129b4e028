// SPDX-License-Identifier: Apache-2.0
// Islands: rows that are connected by nodes and bodies that they can move. Impulses of one island change no velocity
// of another one, so energies of islands add up. Nodes and bodies begin with labels of their own; a row gives the
// largest label of what it moves to all of it, on each rank by union-find, over the ranks by maxima, until nothing
// changes. The islands are a function of the rows alone, not of the ranks.
#pragma once
#include <span>
#include <vector>

#include "contact/data/exchange.hpp"
#include "contact/enforcement/system.hpp"
#include "core/union_find.hpp"

namespace brunt::contact {

struct Islands {
  std::vector<double> labels;      ///< one for each island of all ranks, ascending
  std::vector<LocalIndex> of_row;  ///< island of each row of this rank; no_index: it takes no part
  std::vector<double> node_label;  ///< largest label of what is connected, a contact node each
  std::vector<double> body_label;  ///< the same, a body each
  UnionFind joined = UnionFind();  ///< nodes, then bodies

  void reserve(std::size_t rows, std::size_t nodes, std::size_t bodies);
};

/// takes_part: one flag for each row. Rows that can move nothing take no part. It allocates memory: not for ordinary
/// steps. Collective.
void find_islands(const System& system, std::span<const char> takes_part, Exchange& exchange, Islands& islands);

}  // namespace brunt::contact
