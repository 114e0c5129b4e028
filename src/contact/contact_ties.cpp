// SPDX-License-Identifier: Apache-2.0
// Ties of a run: found once at the start, on the rank of their slaves, and rows of every step.
#include <algorithm>

#include "brunt/contact/contact.hpp"
#include "brunt/core/error.hpp"

namespace brunt::contact {

std::size_t Contact::place_of_pair(std::int32_t slave_block, std::int32_t master_block) const {
  return static_cast<std::size_t>(slave_block) * settings_.pairs.block_count() + static_cast<std::size_t>(master_block);
}

bool Contact::are_tied(std::int32_t slave_block, std::int32_t master_block) const {
  return settings_.tied[place_of_pair(slave_block, master_block)] != Tied::no;
}

/// The block of the slave that is tied to this one, the first of several; no_index where none is.
std::int32_t Contact::tied_block(LocalIndex slave, std::int32_t master_block) const {
  for (const std::int32_t block : surface_.blocks.row(lists_.nodes.surface_node[static_cast<std::size_t>(slave)]))
    if (are_tied(block, master_block)) return block;
  return no_index;
}

void Contact::make_ties(const std::vector<Vec3>& reference, std::span<const Wall> walls) {
  if (settings_.tied.empty()) return;
  look_at_start(reference, walls);
  const auto block_of = [this](LocalIndex face) { return lists_.faces[static_cast<std::size_t>(face)].block; };
  nodes_beside_.assign(settings_.tied.size(), 0);
  ties_ = find_ties(
      lists_.candidates, lists_.faces, lists_.nodes.gid, motion_of_, facet_area_, settings_.detection.encounter,
      [&](LocalIndex slave, LocalIndex face) { return tied_block(slave, block_of(face)) != no_index; },
      [&](LocalIndex slave, LocalIndex face) {
        ++nodes_beside_[place_of_pair(tied_block(slave, block_of(face)), block_of(face))];
      });
  levers_.resize(ties_.size());
  for (Tie& tie : ties_) {
    const auto slave = std::ranges::lower_bound(lists_.nodes.gid, tie.slave) - lists_.nodes.gid.begin();
    tie.slave_block = tied_block(static_cast<LocalIndex>(slave), tie.block);
  }
  forget_start();
}

TiedNodes Contact::tied_nodes() const {
  TiedNodes count{std::vector<GlobalIndex>(settings_.tied.size(), 0), nodes_beside_};
  for (const Tie& tie : ties_) ++count.tied[place_of_pair(tie.slave_block, tie.block)];
  ranks_.sum(count.tied);
  ranks_.sum(count.beside);
  return count;
}

void Contact::lay_ties(double dt) {
  const std::size_t first = rows_.size();
  tie_rows(ties_, tie_scene(dt), levers_, rows_);
  for (Row& row : std::span(rows_).subspan(first)) ask_only_what_can_move(row, mobility_, motion_of_);
}

TieScene Contact::tie_scene(double dt) const {
  return {
      lists_.candidates, lists_.faces, faces_by_key_, lists_.nodes.gid, motion_of_, settings_.detection.recovery, dt};
}

/// Asked of new lists on all ranks, so that all stop.
void Contact::demand_ties_hold() const {
  const TieScene scene = tie_scene(1);
  if (ranks_.any(!std::ranges::all_of(ties_, [&](const Tie& tie) { return holds(tie, scene); })))
    throw GuardError("contact: tied parts have been torn from each other: a face is out of reach of a node tied to it");
}

/// Is the row's slave a node of blocks that have but their ties to do with the master's?
bool Contact::nothing_else_acts(const Row& row) const {
  const auto blocks = surface_.blocks.row(lists_.nodes.surface_node[static_cast<std::size_t>(row.nodes[0])]);
  return std::ranges::all_of(blocks, [&](std::int32_t block) {
    return settings_.tied[place_of_pair(block, row.master_block)] == Tied::alone ||
           settings_.pairs.at(block, row.master_block) == PairRule::apart;
  });
}

/// A tied node has nothing but its tie to do with that body, nor have edges of tied parts with each other.
void Contact::drop_tied_rows() {
  std::erase_if(rows_, [&](const Row& row) {
    if (row.is_wall()) return false;
    if (row.is_edge()) return are_tied(row.slave_block, row.master_block);
    return find_tie(ties_, row.slave_gid, row.master_body) != nullptr || nothing_else_acts(row);
  });
}

}  // namespace brunt::contact
