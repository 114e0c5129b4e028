// SPDX-License-Identifier: Apache-2.0
// The history of contact between steps, as records on the owner of the slave (for an edge: where its rows are created),
// ordered by key. It contains the rows that acted in the last step, and the side on which a node touches a two-sided
// face. It is therefore a function of the motion only, independent of the lists and of the time of their creation.
#pragma once
#include <array>
#include <span>
#include <vector>

#include "contact/data/constraint.hpp"
#include "contact/data/impact_history.hpp"
#include "contact/data/mortar_history.hpp"
#include "contact/data/standard_tolerances.hpp"
#include "core/record_table.hpp"

namespace brunt::contact {

struct HistoryRecord {
  RowKey key{};
  std::array<double, 3> force{};  ///< on the slave: impulse of the row in the last step over its length [force]
  double side = 0;   ///< +1, -1: the side of a two-sided face, along and against its normal; 0 of other rows
  double unmet = 0;  ///< 1: the row could not be satisfied, and has been closed since (see contact/unmet.hpp)
};

struct AnchorRecord {
  AnchorKey key{};
  GlobalIndex face = 0;             ///< of a node on a face: key of the one that holds the anchor
  std::array<double, 4> weights{};  ///< of the face's corners at the anchor; of both edges' ends
  std::array<double, 3> on_wall{};  ///< the anchor less the wall's point [length]
};

/// The limit of lagging friction (see FrictionLaw::lag). It has the key of anchors, so that it remains with a node that
/// slides to the next face. If several rows have one key, it is the mean over the pressed ones, if any.
struct LimitRecord {
  AnchorKey key{};
  double limit = 0;  ///< after the last step [force]
  bool pressed =
      false;  ///< whether its row was pressed in the step that wrote it; used in that step only, not in checkpoints
};

/// Initial and present depth of a node behind a face that has become exterior in front of it (see contact/births.hpp).
/// It has the key of anchors: node and body of the master.
struct BirthRecord {
  AnchorKey key{};
  double penetration = 0;  ///< from which gaps are measured [length]
  double depth = 0;        ///< of the node behind the deepest of the body's faces, in the last step [length] > 0
};

inline AnchorKey anchor_key_of(const Row& row) {
  const RowKey& key = row.key;
  if (row.is_edge()) return {RowKind::edge, key.slave, key.master, key.slave_second, key.master_second};
  if (row.is_wall()) return {.kind = RowKind::wall, .slave = key.slave, .master = key.master};
  return {.slave = key.slave, .master = row.master_body};
}

/// All in ascending order of their keys.
struct History {
  std::vector<HistoryRecord> pairs;
  std::vector<AnchorRecord> anchors;
  std::vector<LimitRecord> limits;
  std::vector<BirthRecord> births;
  std::vector<ImpactRecord> impacts;
  MortarHistory mortar;

  void clear() {
    mortar.clear();
    pairs.clear();
    anchors.clear();
    limits.clear();
    births.clear();
    impacts.clear();
  }
};

/// Calls visit(q, record) for each row that has a record; rows and records in ascending order of their keys.
template <class Visit>
void for_each_remembered(std::span<const Row> rows, std::span<const HistoryRecord> records, Visit&& visit) {
  auto record = records.begin();
  for (std::size_t q = 0; q < rows.size(); ++q) {
    const RowKey& key = rows[q].key;
    while (record != records.end() && record->key < key) ++record;
    if (record == records.end()) return;
    if (record->key == key) visit(q, *record);
  }
}

/// The anchor of a row's slave on its master, or null.
const AnchorRecord* find_anchor(std::span<const AnchorRecord> anchors, const AnchorKey& key);

/// The birth of a node in front of a body, or null.
const BirthRecord* find_birth(std::span<const BirthRecord> births, const AnchorKey& key);

/// Initial impulses of the iteration [momentum]: the admissible part of the forces of the last step, over a step of
/// length dt. If a slave has moved to the next face, its row there starts from the force of the row that no longer
/// exists, provided that this force points along the new normal: nodes that rest on an edge between faces often change
/// sides. Zero for rows that did not act. Rows in order.
void start_impulses(std::span<const Row> rows, std::span<const HistoryRecord> records, double dt,
                    std::span<Vec3> impulses, const Tolerances& tolerances = standard_tolerances);

/// The records of a step of length dt: rows that acted, and the sides found (in order of their keys). Does not allocate
/// if `records` has room for all rows and sides. unmet: a flag a row, kept also where a row has no impulse; empty:
/// none.
void write_pairs(std::span<const Row> rows, std::span<const Vec3> impulses, double dt,
                 std::span<const HistoryRecord> sides, std::vector<HistoryRecord>& records,
                 std::span<const char> unmet = {});

/// Calls visit(q) for each row whose slave has an unmet record: a node that slides on to the next face remains known.
template <class Visit>
void for_each_unmet(std::span<const Row> rows, std::span<const HistoryRecord> records, Visit&& visit) {
  auto record = records.begin();
  for (std::size_t q = 0; q < rows.size(); ++q) {
    const auto own = slave_of(rows[q].key);
    while (record != records.end() && slave_of(record->key) < own) ++record;
    for (auto other = record; other != records.end() && slave_of(other->key) == own; ++other)
      if (other->unmet != 0) {
        visit(q);
        break;
      }
  }
}

/// Converts the history to tables for checkpoints and the state hash, and back. The last one is that of impacts, which
/// only scenes with Impact::elastic have.
using HistoryTables = std::array<RecordTable, 7>;
void to_tables(const History& history, HistoryTables& tables);
/// Without mortar rows, whose tables mortar_heads_from and mortar_terms_from read.
History from_tables(const HistoryTables& tables);

}  // namespace brunt::contact
