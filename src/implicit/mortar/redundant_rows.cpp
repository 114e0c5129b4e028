// SPDX-License-Identifier: Apache-2.0
// Multipliers that are redundant with supports, walls and other multipliers. Each rank selects the few rows that may be
// redundant; all ranks process all of them in the same order.
#include <algorithm>
#include <bit>
#include <map>

#include "comm/rendezvous.hpp"
#include "contact/mortar/redundant.hpp"
#include "implicit/mortar/mortar.hpp"
#include "mortar_shares.hpp"
#include "self_sides.hpp"

namespace brunt::implicit {
namespace {

contact::Equations equations_of(const Interface& face) {
  contact::Equations equations;
  equations.weights = face.pair.tied ? &face.start.tie.weights : &face.iterate.rows.weights;
  equations.covered = face.pair.tied ? face.start.tie.covered : face.iterate.rows.covered;
  equations.slaves = face.surfaces.rows;
  if (face.pair.tied) {
    equations.held = face.start.tied;
    if (face.start.tie.apart) equations.levers = &face.iterate.levers;
    return equations;
  }
  // of redundant rows those with previous pressure remain active: otherwise they would alternate
  equations.preferred.resize(face.count());
  equations.held.assign(face.count(), Mat3::Zero());
  if (!face.is_exact()) return equations;  // penalties and compliant rows yield to others
  for (std::size_t row = 0; row < face.count(); ++row) {
    const Vec3& normal = face.iterate.rows.normals[row];
    if (face.iterate.active[row] != 0) equations.held[row] = normal * normal.transpose();
    equations.preferred[row] = face.iterate.z[row] > 0 ? 1 : 0;
  }
  return equations;
}

/// The directions of the rows of ties, from the free directions of each row's own nodes.
void find_tied(MortarContact& contact) {
  for (Interface& face : contact.interfaces) {
    if (!face.pair.tied) continue;
    face.start.tied = contact::tied_directions(face.surfaces, face.start.tie, contact.nodes.movable);
    face.start.given_apart.resize(face.count());
    for (std::size_t row = 0; row < face.count(); ++row)
      face.start.given_apart[row] =
          face.start.tie.covered[row] > 0 ? Mat3(Mat3::Identity() - face.start.tied[row]) : Mat3::Zero();
  }
}

/// Adds the nodes of this rank that have several pressed rows, at sharp edges.
std::vector<std::uint8_t> with_several_rows(const MortarContact& contact, std::vector<std::uint8_t> shared) {
  std::vector<std::uint8_t> rows(contact.nodes.lasting, 0);
  for (const Interface& face : contact.interfaces)
    for (std::size_t row = 0; face.presses() && face.is_exact() && row < face.count(); ++row) {
      const auto node = static_cast<std::size_t>(face.surfaces.rows[row]);
      if (face.iterate.active[row] != 0 && rows[node]++ > 0) shared[node] = 1;
    }
  return shared;
}

/// Whether a row of this rank may be redundant.
bool is_in_question(const MortarContact& contact) {
  const ContactNodes& nodes = contact.nodes;
  const std::vector<std::uint8_t> shared = with_several_rows(contact, nodes.several);
  for (const Interface& face : contact.interfaces)
    if (face.is_exact() && !contact::lines_to_look_at(equations_of(face), {nodes.gid, nodes.movable, shared}).empty())
      return true;
  return false;
}

/// A node with a coefficient in equations of an interface.
struct NodeSeen {
  GlobalIndex gid = 0;
  std::int64_t interface = 0;  ///< and of which side, where a part meets itself
};

/// For each node of contact that this rank owns: whether equations of several interfaces, or of both sides of one,
/// contain it. Collective.
std::vector<std::uint8_t> shared_nodes(const comm::Communicator& ranks, const MortarContact& contact,
                                       const std::vector<contact::Equations>& equations) {
  const ContactNodes& nodes = contact.nodes;
  std::vector<std::uint8_t> shared(nodes.gid.size(), 0);
  if (!contact.shares_nodes) return shared;
  std::vector<std::vector<NodeSeen>> to_owner(static_cast<std::size_t>(ranks.size()));
  std::vector<std::int64_t> told(nodes.gid.size(), -1);
  for (std::size_t k = 0; k < equations.size(); ++k)
    for (std::size_t row = 0; row < equations[k].held.size(); ++row) {
      if (equations[k].held[row].isZero(0)) continue;
      for (const LocalIndex place : equations[k].weights->nodes.row(static_cast<LocalIndex>(row))) {
        const auto node = static_cast<std::size_t>(place);
        if (nodes.several[node] == 0) continue;
        const Interface& face = contact.interfaces[k];
        const bool of_master = face.self && !is_of_slave(face, row, place);
        const std::int64_t interface = 2 * static_cast<std::int64_t>(k) + (of_master ? 1 : 0);
        if (told[node] == interface) continue;
        told[node] = interface;
        nth(to_owner, nodes.source[node].rank).push_back({nodes.gid[node], interface});
      }
    }
  std::map<GlobalIndex, std::int64_t> first;
  for (const NodeSeen& seen : comm::exchange(ranks, to_owner).values) {
    const auto [known, fresh] = first.emplace(seen.gid, seen.interface);
    if (!fresh && known->second != seen.interface) nth(shared, nodes.place_of(seen.gid)) = 1;
  }
  return shared;
}

/// Position of a line in the elimination.
struct Turn {
  GlobalIndex after_preferred = 0, interface = 0, place = 0;
  friend auto operator<=>(const Turn&, const Turn&) = default;
};

/// Lines of this rank as words: position, number of terms, columns and values.
void write(const Turn& turn, const contact::Line& line, std::vector<GlobalIndex>& words) {
  words.insert(words.end(), {turn.after_preferred, turn.interface, turn.place, static_cast<GlobalIndex>(line.size())});
  for (const auto& [column, value] : line) {
    words.push_back(column);
    words.push_back(std::bit_cast<GlobalIndex>(value));
  }
}

struct Told {
  Turn turn;
  std::size_t at = 0;  ///< first of its words
};

/// Redundant lines, as a flag for each in the order of `told`. `words`: of all ranks.
std::vector<std::uint8_t> implied_of(const std::vector<GlobalIndex>& words, std::vector<Told>& told) {
  constexpr std::size_t header = 4;
  for (std::size_t at = 0; at < words.size(); at += header + 2 * static_cast<std::size_t>(words[at + 3]))
    told.push_back({{words[at], words[at + 1], words[at + 2]}, at});
  std::ranges::stable_sort(told, {}, &Told::turn);  // directions of one row come from one rank, in order
  contact::Echelon echelon;
  std::vector<std::uint8_t> implied;
  for (const Told& next : told) {
    contact::Line line;
    for (std::size_t k = 0; k < static_cast<std::size_t>(words[next.at + 3]); ++k)
      line.emplace(words[next.at + header + 2 * k], std::bit_cast<double>(words[next.at + header + 2 * k + 1]));
    implied.push_back(echelon.add(std::move(line)) ? 0 : 1);
  }
  return implied;
}

/// Removes from Equations::held the directions implied by previous rows, preferred ones first. Collective.
void leave_out_implied(const comm::Communicator& ranks, const MortarContact& contact,
                       std::vector<contact::Equations>& equations) {
  const std::vector<std::uint8_t> shared = with_several_rows(contact, shared_nodes(ranks, contact, equations));
  struct Own {
    Turn turn;
    std::size_t interface = 0;
    contact::RowLine of;
  };
  std::vector<Own> own;
  for (std::size_t k = 0; k < equations.size(); ++k)
    for (contact::RowLine& line :
         contact::lines_to_look_at(equations[k], {contact.nodes.gid, contact.nodes.movable, shared})) {
      const bool first = equations[k].preferred.empty() || equations[k].preferred[line.row] != 0;
      const Turn turn{first ? 0 : 1, static_cast<GlobalIndex>(k), contact.interfaces[k].numbering.place[line.row]};
      own.push_back({turn, k, std::move(line)});
    }
  std::ranges::stable_sort(own, {}, &Own::turn);
  std::vector<GlobalIndex> mine;
  for (const Own& line : own) write(line.turn, line.of.line, mine);
  std::vector<Told> told;
  const std::vector<std::uint8_t> implied = implied_of(
      comm::exchange(ranks, std::vector<std::vector<GlobalIndex>>(static_cast<std::size_t>(ranks.size()), mine)).values,
      told);
  std::size_t next = 0;
  for (std::size_t k = 0; k < told.size() && next < own.size(); ++k) {
    if (told[k].turn != own[next].turn) continue;
    const contact::RowLine& line = own[next].of;
    if (implied[k] != 0) equations[own[next].interface].held[line.row] -= line.direction * line.direction.transpose();
    ++next;
  }
}

}  // namespace

void leave_out_redundant(const comm::Communicator& ranks, std::span<const Mat3> movable, MortarContact& contact) {
  ContactNodes& nodes = contact.nodes;
  bool changed = false;
  for (std::size_t k = 0; k < nodes.lasting; ++k)
    changed = changed || (nodes.own[k] != no_index && movable[k] != nodes.movable[k]);
  if (!changed) find_tied(contact);
  const GlobalIndex most = ranks.max(GlobalIndex{changed ? 2 : is_in_question(contact) ? 1 : 0});
  if (most == 0) return;
  if (most == 2) {
    share_movable(movable, nodes);
    find_tied(contact);
  }
  std::vector<contact::Equations> equations;
  for (const Interface& face : contact.interfaces) equations.push_back(equations_of(face));
  leave_out_implied(ranks, contact, equations);
  for (std::size_t k = 0; k < equations.size(); ++k) {
    Interface& face = contact.interfaces[k];
    if (face.pair.tied)
      face.start.tied = std::move(equations[k].held);
    else if (face.is_exact())
      for (std::size_t row = 0; row < face.count(); ++row)
        if (equations[k].held[row].isZero()) face.iterate.active[row] = 0;
  }
}

}  // namespace brunt::implicit
