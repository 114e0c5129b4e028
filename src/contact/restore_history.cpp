// SPDX-License-Identifier: Apache-2.0
// Sends records of contact's history to the ranks that create their rows: after a restart on any number of ranks, and
// after a change of the surface.
#include <algorithm>
#include <vector>

#include "comm/rendezvous.hpp"
#include "contact/contact.hpp"
#include "move_history.hpp"

namespace brunt::contact {
namespace {

Rank desk_of(GlobalIndex gid, std::size_t ranks) {
  return static_cast<Rank>(static_cast<std::size_t>(gid) % ranks);
}

/// Slaves whose records may belong here: owned nodes, and the first ends of edges. Ascending.
std::vector<GlobalIndex> slaves_here(const Surface& surface, Rank rank) {
  std::vector<GlobalIndex> slaves;
  for (std::size_t i = 0; i < surface.gid.size(); ++i)
    if (surface.owns(static_cast<LocalIndex>(i), rank)) slaves.push_back(surface.gid[i]);
  for (const SurfaceEdge& edge : surface.edges) slaves.push_back(nth(surface.gid, edge.nodes[0]));
  std::ranges::sort(slaves);
  slaves.erase(std::unique(slaves.begin(), slaves.end()), slaves.end());
  return slaves;
}

/// Records and the ranks that need them are matched at a rank determined by the slave's gid. Returns every record of
/// the requested slaves. Collective.
template <class Record>
std::vector<Record> fetch(const comm::Communicator& ranks, const std::vector<Record>& records,
                          const std::vector<GlobalIndex>& slaves) {
  const auto count = static_cast<std::size_t>(ranks.size());
  std::vector<std::vector<Record>> to_desk(count), answers(count);
  std::vector<std::vector<GlobalIndex>> questions(count);
  for (const Record& record : records) nth(to_desk, desk_of(record.key.slave, count)).push_back(record);
  for (const GlobalIndex slave : slaves) nth(questions, desk_of(slave, count)).push_back(slave);
  std::vector<Record> on_desk = comm::exchange(ranks, to_desk).values;
  const auto slave_of = [](const Record& record) { return record.key.slave; };
  std::ranges::sort(on_desk, {}, slave_of);
  const Ragged<GlobalIndex> asked = comm::exchange(ranks, questions);
  for (std::size_t r = 0; r < count; ++r)
    for (const GlobalIndex slave : asked.row(static_cast<LocalIndex>(r))) {
      const auto first = std::ranges::lower_bound(on_desk, slave, {}, slave_of);
      answers[r].insert(answers[r].end(), first, std::ranges::upper_bound(first, on_desk.end(), slave, {}, slave_of));
    }
  return comm::exchange(ranks, answers).values;
}

}  // namespace

HistoryTables history_tables(const Contact& contact) {
  HistoryTables tables;
  to_tables(contact.history, tables);
  return tables;
}

namespace {

/// heads, terms: of mortar rows, on whichever rank. Collective.
void move_history(std::vector<MortarHead> heads, std::vector<MortarTermRecord> terms, Contact& contact) {
  const Surface& surface = contact.surface;
  const Rank here = contact.ranks.rank();
  History& history = contact.history;
  const std::vector<GlobalIndex> slaves = slaves_here(surface, here);
  history.pairs = fetch(contact.ranks, history.pairs, slaves);
  history.anchors = fetch(contact.ranks, history.anchors, slaves);
  history.limits = fetch(contact.ranks, history.limits, slaves);
  history.births = fetch(contact.ranks, history.births, slaves);
  if (contact.derived.elastic_impact) history.impacts = fetch(contact.ranks, history.impacts, slaves);
  heads = fetch(contact.ranks, heads, slaves);
  terms = fetch(contact.ranks, terms, slaves);
  const auto owns = [&](GlobalIndex gid) {
    const auto found = std::ranges::lower_bound(surface.gid, gid);
    return found != surface.gid.end() && *found == gid &&
           surface.owns(static_cast<LocalIndex>(found - surface.gid.begin()), here);
  };
  const auto ends = [&](const SurfaceEdge& edge) {
    return std::array{nth(surface.gid, edge.nodes[0]), nth(surface.gid, edge.nodes[1])};
  };
  const auto belongs_elsewhere = [&](const auto& record) {
    const GlobalIndex slave = record.key.slave, second = record.key.slave_second;
    return record.key.kind != RowKind::edge
               ? !owns(slave)
               : !std::ranges::binary_search(surface.edges, std::array{slave, second}, {}, ends);
  };
  std::erase_if(history.pairs, belongs_elsewhere);
  std::erase_if(history.anchors, belongs_elsewhere);
  std::erase_if(history.limits, belongs_elsewhere);
  std::erase_if(history.births, belongs_elsewhere);
  std::erase_if(history.impacts, belongs_elsewhere);
  std::erase_if(heads, belongs_elsewhere);
  std::erase_if(terms, belongs_elsewhere);
  history.mortar = mortar_history_from(std::move(heads), std::move(terms));
  std::ranges::sort(history.pairs, {}, &HistoryRecord::key);
  std::ranges::sort(history.anchors, {}, &AnchorRecord::key);
  std::ranges::sort(history.limits, {}, &LimitRecord::key);
  std::ranges::sort(history.births, {}, &BirthRecord::key);
  std::ranges::sort(history.impacts, {}, &ImpactRecord::key);
}

}  // namespace

void move_history(Contact& contact) {
  move_history(contact.history.mortar.heads, term_records(contact.history.mortar), contact);
}

void restore_history(const HistoryTables& tables, Contact& contact) {
  contact.history = from_tables(tables);
  move_history(mortar_heads_from(tables[4]), mortar_terms_from(tables[5]), contact);
}

}  // namespace brunt::contact
