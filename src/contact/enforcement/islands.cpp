// SPDX-License-Identifier: Apache-2.0
#include "contact/enforcement/islands.hpp"

#include <algorithm>
#include <numeric>

namespace brunt::contact {
namespace {

/// The first of the bodies that joints connect with this one.
LocalIndex first_of(const Carriers& carriers, LocalIndex body) {
  const CoupledBodies* group = carriers.group_of(body);
  return group == nullptr ? body : group->bodies.front();
}

/// Calls use(i) for each node and, behind all nodes, each body that row q can move.
template <class Use>
void for_each_moved(const System& system, std::size_t q, const Use& use) {
  for (std::size_t k = system.rows.begin(q); k < system.rows.end(q); ++k)
    if (const std::size_t node = system.rows.point(k); system.mobility[node].inverse_mass > 0) use(node);
  for (const BodyShare& share : system.rows.bodies_of(q))
    if (share.weight > 0) use(system.motion.size() + static_cast<std::size_t>(first_of(system.carriers, share.body)));
}

void join_rows(const System& system, std::span<const char> takes_part, UnionFind& joined) {
  for (std::size_t q = 0; q < system.rows.size(); ++q) {
    if (takes_part[q] == 0) continue;
    std::size_t first = joined.size();
    for_each_moved(system, q, [&](std::size_t one) {
      if (first == joined.size()) first = one;
      joined.join(first, one);
    });
  }
}

/// Gives the largest label of each connected set of this rank to all of the set. Did any label change?
bool raise_labels(Islands& islands) {
  const std::size_t nodes = islands.node_label.size();
  const auto label_of = [&](std::size_t one) -> double& {
    return one < nodes ? islands.node_label[one] : islands.body_label[one - nodes];
  };
  bool changed = false;
  for (const bool down : {false, true})
    for (std::size_t one = 0; one < islands.joined.size(); ++one) {
      double &own = label_of(one), &of_root = label_of(islands.joined.first(one));
      double& behind = down ? own : of_root;
      const double ahead = down ? of_root : own;
      if (!(behind < ahead)) continue;
      behind = ahead;
      changed = true;  // of the first member too, which other ranks may share
    }
  return changed;
}

void spread_over_ranks(Exchange& exchange, Islands& islands) {
  exchange.max_to_owner(islands.node_label, 1);
  exchange.share(islands.node_label, 1);
  exchange.max(islands.body_label);
}

}  // namespace

void Islands::reserve(std::size_t rows, std::size_t nodes, std::size_t bodies) {
  labels.reserve(rows);
  of_row.reserve(rows);
  node_label.reserve(nodes);
  body_label.reserve(bodies);
  joined.reserve(nodes + bodies);
}

void find_islands(const System& system, std::span<const char> takes_part, Exchange& exchange, Islands& islands) {
  const std::size_t nodes = system.motion.size(), bodies = system.carriers.bodies.size();
  islands.node_label.resize(nodes);
  for (std::size_t n = 0; n < nodes; ++n)
    islands.node_label[n] = static_cast<double>(bodies) +
                            (system.gid.empty() ? static_cast<double>(n) : static_cast<double>(system.gid[n]));
  islands.body_label.resize(bodies);
  std::iota(islands.body_label.begin(), islands.body_label.end(), 0.0);
  islands.joined.reset(nodes + bodies);
  join_rows(system, takes_part, islands.joined);
  raise_labels(islands);
  for (std::int64_t changed = 1; changed > 0;) {
    spread_over_ranks(exchange, islands);
    changed = raise_labels(islands) ? 1 : 0;
    exchange.sum({&changed, 1});
  }
  islands.labels.clear();
  islands.of_row.assign(system.rows.size(), no_index);
  const auto label_of_row = [&](std::size_t q) {
    double label = -1;
    for_each_moved(system, q, [&](std::size_t one) {
      label = one < nodes ? islands.node_label[one] : islands.body_label[one - nodes];
    });
    return label;
  };
  for (std::size_t q = 0; q < system.rows.size(); ++q)
    if (takes_part[q] != 0)
      if (const double label = label_of_row(q); label >= 0) islands.labels.push_back(label);
  exchange.unite(islands.labels);
  for (std::size_t q = 0; q < system.rows.size(); ++q) {
    if (takes_part[q] == 0) continue;
    const double label = label_of_row(q);
    if (label < 0) continue;
    const auto found = std::ranges::lower_bound(islands.labels, label);
    islands.of_row[q] = static_cast<LocalIndex>(found - islands.labels.begin());
  }
}

}  // namespace brunt::contact
