// SPDX-License-Identifier: Apache-2.0
// The weights of mortar rows (contact/mortar_rows), kept from step to step: integrals over the segments of the facets
// around a slave node. They are state, since they depend on where the bodies were when they were integrated.
#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "contact/data/row_key.hpp"
#include "core/ragged.hpp"
#include "core/record_table.hpp"
#include "core/types.hpp"

namespace brunt::contact {

/// One row of a slave node: key.master is the master's body, key.master_second the number of the row among those of the
/// node with this body, one for each smooth part of the node's surface.
struct MortarHead {
  RowKey key{};
  std::int32_t block = 0;         ///< lowest one of the master's facets
  std::array<double, 3> slip{};   ///< of a node that sticks, since it came to rest [length]
  std::array<double, 3> apart{};  ///< sum of weights and positions when they were integrated [length]
  double area = 0;                ///< integral of the row's function over what is covered [length^2]
  double size = 0;                ///< longest edge of the facets [length]
  double whole = 0;               ///< 1: all facets are covered whole; else 0
  double born = 0;                ///< depth that came with an integration; gaps are measured from it [length]
  double age = 0;                 ///< steps since the integration
};

enum class MortarPart : std::int8_t { slave, master, facet };

/// Of a node its weight, of sum 1 over the slave's nodes and -1 over the master's; of a slave facet its share of
/// `area`.
struct MortarTerm {
  GlobalIndex id = 0;  ///< gid of the node, key of the facet
  double weight = 0;
  double reach = 0;  ///< of a node: integral of its shape function over what is covered, of sum 1 on either side
  MortarPart part = MortarPart::slave;
};

/// In ascending order of the keys. Terms of a row: the slave node itself, the master's nodes in ascending gid, the
/// other nodes of the slave's surface likewise, facets by key.
struct MortarHistory {
  std::vector<MortarHead> heads;
  Ragged<MortarTerm> terms;

  void clear() {
    heads.clear();
    terms.clear();
  }
  void append(const MortarHead& head, std::span<const MortarTerm> of_row) {
    heads.push_back(head);
    terms.values.insert(terms.values.end(), of_row.begin(), of_row.end());
    terms.close_row();
  }
};

/// The same as single records, each with its key, which can be sent.
struct MortarTermRecord {
  RowKey key{};
  MortarTerm term{};
};
std::vector<MortarTermRecord> term_records(const MortarHistory& history);
/// From heads and terms in any order.
MortarHistory mortar_history_from(std::vector<MortarHead> heads, std::vector<MortarTermRecord> terms);

/// For checkpoints and the state hash: heads, terms.
std::array<RecordTable, 2> mortar_tables(const MortarHistory& history);
/// From tables, whose parts on a rank need not belong together.
std::vector<MortarHead> mortar_heads_from(const RecordTable& table);
std::vector<MortarTermRecord> mortar_terms_from(const RecordTable& table);

}  // namespace brunt::contact
