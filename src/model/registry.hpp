// SPDX-License-Identifier: Apache-2.0
// Every array that a step reads and changes, declared once, and tables of records that are created and deleted.
// Checkpoint, restart and the state hash use these lists only.
#pragma once
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "core/record_table.hpp"
#include "core/types.hpp"

namespace brunt::model {

/// A view of `components` doubles for each of `count` entities in any memory layout:
/// value(entity, c) = data[(entity / lanes) * batch_stride + c * component_stride + entity % lanes * lane_stride].
/// Plain rows: lanes 1, batch_stride = row length, component_stride 1. Batches of elements: lanes = pack_width,
/// batch_stride = pack_width * components of the batch, component_stride = pack_width, lane_stride 1.
struct StateArray {
  std::string name;  ///< unique: "displacement", "block/bar/stress"
  enum class Entity { node, element, global } entity = Entity::node;
  std::int32_t block = -1;  ///< for elements: which block
  LocalIndex count = 0;     ///< entities on this rank
  int components = 0;
  double* data = nullptr;
  int lanes = 1, batch_stride = 0, component_stride = 1, lane_stride = 0;
  bool saved = true, hashed = true;
  bool expected = true;  ///< false: a checkpoint may lack it, and then it stays as it is

  [[nodiscard]] double& at(LocalIndex entity_index, int c) const {
    return data[static_cast<std::ptrdiff_t>(entity_index / lanes) * batch_stride +
                static_cast<std::ptrdiff_t>(c) * component_stride +
                static_cast<std::ptrdiff_t>(entity_index % lanes) * lane_stride];
  }
};

/// The arrays of one rank, with the data that place them in the whole model.
struct Registry {
  GlobalIndex global_nodes = 0;
  std::vector<GlobalIndex> owned_node_gid;                ///< gids of the nodes this rank owns
  std::vector<LocalIndex> owned_node;                     ///< their local indices
  std::span<const GlobalIndex> node_gid;                  ///< of all local nodes
  std::vector<std::span<const GlobalIndex>> element_gid;  ///< per block
  std::vector<GlobalIndex> block_first, block_count;      ///< gid range of each block in the whole model
  std::vector<StateArray> arrays;  ///< global arrays (time, dt, step ...) have count 1 and are the same on every rank
  /// Saved and hashed, with the same names on every rank. Each record is on one rank. After reading a checkpoint it may
  /// be on any rank; the owner of the table sends it to the right one.
  std::vector<RecordTable*> tables;
};

}  // namespace brunt::model
