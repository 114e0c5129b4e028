// SPDX-License-Identifier: Apache-2.0
// Registry arrays to and from the block layout (see the header).
#include "checkpoint_tables.hpp"

#include <numeric>

namespace brunt::io {

using Entity = model::StateArray::Entity;

std::vector<SavedTable> saved_tables(const model::Registry& registry) {
  std::vector<SavedTable> tables;
  for (const model::StateArray& array : registry.arrays) {
    if (!array.saved || array.components == 0) continue;
    switch (array.entity) {
      case Entity::node:
        tables.push_back({"/nodes/" + array.name, &array, registry.global_nodes});
        break;
      case Entity::element:
        tables.push_back(
            {"/elements/" + array.name, &array, registry.block_count.at(static_cast<std::size_t>(array.block))});
        break;
      case Entity::global:
        tables.push_back({"/globals/" + array.name, &array, array.count});
        break;
    }
  }
  return tables;
}

TableLayout::TableLayout(const comm::Communicator& ranks, const model::Registry& registry, Nodes nodes)
    : rank_(ranks.rank()), node_(registry.owned_node) {
  if (nodes == Nodes::all) {
    node_.resize(registry.node_gid.size());
    std::iota(node_.begin(), node_.end(), 0);
  }
  const std::span<const GlobalIndex> gids =
      nodes == Nodes::all ? registry.node_gid : std::span<const GlobalIndex>(registry.owned_node_gid);
  nodes_ = comm::BlockRedistribution(ranks, registry.global_nodes, gids);
  for (std::size_t b = 0; b < registry.block_count.size(); ++b) {
    std::vector<GlobalIndex> in_block(registry.element_gid[b].begin(), registry.element_gid[b].end());
    for (GlobalIndex& gid : in_block) gid -= registry.block_first[b];
    elements_.emplace_back(ranks, registry.block_count[b], in_block);
  }
}

const comm::BlockRedistribution& TableLayout::redistribution(const model::StateArray& array) const {
  return array.entity == Entity::node ? nodes_ : elements_.at(static_cast<std::size_t>(array.block));
}

LocalIndex TableLayout::held(const model::StateArray& array) const {
  return array.entity == Entity::node ? static_cast<LocalIndex>(node_.size()) : array.count;
}

LocalIndex TableLayout::entity(const model::StateArray& array, LocalIndex i) const {
  return array.entity == Entity::node ? nth(node_, i) : i;
}

RowRange TableLayout::rows(const SavedTable& table) const {
  if (table.array->entity == Entity::global) return {0, static_cast<LocalIndex>(table.rows)};
  const comm::BlockLayout& layout = redistribution(*table.array).layout();
  return {layout.first(rank_), layout.count(rank_)};
}

std::vector<double> TableLayout::to_blocks(const SavedTable& table) const {
  const model::StateArray& array = *table.array;
  const auto width = static_cast<std::size_t>(array.components);
  std::vector<double> block(static_cast<std::size_t>(rows(table).count) * width);
  if (array.entity == Entity::global) {
    for (std::size_t k = 0; k < block.size(); ++k)
      block[k] = array.at(static_cast<LocalIndex>(k / width), static_cast<int>(k % width));
    return block;
  }
  // column by column: a whole table three times over would be most of the memory of a run
  std::vector<double> held_column(static_cast<std::size_t>(held(array))),
      column(static_cast<std::size_t>(rows(table).count));
  for (int c = 0; c < array.components; ++c) {
    for (LocalIndex i = 0; i < held(array); ++i) nth(held_column, i) = array.at(entity(array, i), c);
    redistribution(array).to_blocks(held_column, column, 1);
    for (std::size_t i = 0; i < column.size(); ++i) block[i * width + static_cast<std::size_t>(c)] = column[i];
  }
  return block;
}

void TableLayout::from_blocks(const SavedTable& table, const std::vector<double>& block) const {
  const model::StateArray& array = *table.array;
  std::vector<double> values(static_cast<std::size_t>(held(array)) * static_cast<std::size_t>(array.components));
  if (array.entity == Entity::global)
    values = block;
  else
    redistribution(array).from_blocks(block, values, array.components);
  std::size_t k = 0;
  for (LocalIndex i = 0; i < held(array); ++i)
    for (int c = 0; c < array.components; ++c) array.at(entity(array, i), c) = values[k++];
}

}  // namespace brunt::io
