// SPDX-License-Identifier: Apache-2.0
// The saved arrays of a registry as tables in canonical order; each rank has a block of rows.
#pragma once
#include <string>
#include <vector>

#include "comm/rendezvous.hpp"
#include "model/registry.hpp"

namespace brunt::io {

/// One table of a checkpoint.
struct SavedTable {
  std::string path;  ///< in the file: /nodes/displacement
  const model::StateArray* array = nullptr;
  GlobalIndex rows = 0;  ///< of the whole model
};

std::vector<SavedTable> saved_tables(const model::Registry& registry);

/// Rows of this rank: the block layout for nodes and elements; for global values all rows, but only the root writes.
struct RowRange {
  GlobalIndex first = 0;
  LocalIndex count = 0;
};

/// Moves arrays between the ranks' layout and the block layout.
class TableLayout {
 public:
  enum class Nodes { owned, all };  ///< write owned nodes; read all of this rank
  /// Collective.
  TableLayout(const comm::Communicator& ranks, const model::Registry& registry, Nodes nodes);

  [[nodiscard]] RowRange rows(const SavedTable& table) const;
  /// Collective.
  [[nodiscard]] std::vector<double> to_blocks(const SavedTable& table) const;
  /// Collective.
  void from_blocks(const SavedTable& table, const std::vector<double>& block) const;

 private:
  [[nodiscard]] const comm::BlockRedistribution& redistribution(const model::StateArray& array) const;
  [[nodiscard]] LocalIndex held(const model::StateArray& array) const;
  [[nodiscard]] LocalIndex entity(const model::StateArray& array, LocalIndex i) const;

  Rank rank_ = 0;
  std::vector<LocalIndex> node_;  // local indices of the nodes carried
  comm::BlockRedistribution nodes_;
  std::vector<comm::BlockRedistribution> elements_;  // per block
};

}  // namespace brunt::io
