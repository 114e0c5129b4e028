// SPDX-License-Identifier: Apache-2.0
// Ties of a run: found once at the start, on the rank of their slaves, and rows of every step.
#include <algorithm>

#include "brunt/contact/contact.hpp"
#include "brunt/core/error.hpp"

namespace brunt::contact {

bool Contact::are_tied(std::int32_t slave_block, std::int32_t master_block) const {
  const std::size_t pair =
      static_cast<std::size_t>(slave_block) * settings_.pairs.block_count() + static_cast<std::size_t>(master_block);
  return settings_.tied[pair] != 0;
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
  ties_ = find_ties(lists_.candidates, lists_.faces, lists_.nodes.gid, motion_of_, settings_.detection.encounter,
                    [this](LocalIndex slave, LocalIndex face) {
                      return tied_block(slave, lists_.faces[static_cast<std::size_t>(face)].block) != no_index;
                    });
  for (Tie& tie : ties_) {
    const auto slave = std::ranges::lower_bound(lists_.nodes.gid, tie.slave) - lists_.nodes.gid.begin();
    tie.slave_block = tied_block(static_cast<LocalIndex>(slave), tie.block);
  }
  // Impulses that act an offset apart turn the bodies, and a drift taken back with them feeds itself: then all ties
  // hold velocities alone, whose work is none.
  ties_are_flush_ = !ranks_.any(!std::ranges::all_of(ties_, &Tie::flush));
  forget_start();
}

std::vector<GlobalIndex> Contact::tied_nodes() const {
  std::vector<GlobalIndex> count(settings_.tied.size(), 0);
  for (const Tie& tie : ties_)
    ++count[static_cast<std::size_t>(tie.slave_block) * settings_.pairs.block_count() +
            static_cast<std::size_t>(tie.block)];
  ranks_.sum(count);
  return count;
}

TieScene Contact::tie_scene(double dt) const {
  const double recovery = ties_are_flush_ ? settings_.detection.recovery : 0.0;
  return {lists_.candidates, lists_.faces, faces_by_key_, lists_.nodes.gid, motion_of_, recovery, dt};
}

/// Asked of new lists on all ranks, so that all stop.
void Contact::demand_ties_hold() const {
  const TieScene scene = tie_scene(1);
  if (ranks_.any(!std::ranges::all_of(ties_, [&](const Tie& tie) { return holds(tie, scene); })))
    throw GuardError("contact: tied parts have been torn from each other: a face is out of reach of a node tied to it");
}

/// A tied node has nothing but its tie to do with that body, nor have edges of tied parts with each other.
void Contact::drop_tied_rows() {
  std::erase_if(rows_, [&](const Row& row) {
    if (row.is_wall()) return false;
    if (row.is_edge()) return are_tied(row.slave_block, row.master_block);
    return find_tie(ties_, row.slave_gid, row.master_body) != nullptr;
  });
}

}  // namespace brunt::contact
