// SPDX-License-Identifier: Apache-2.0
// What contact remembers from one step to the next, as plain records that lie with the owner of the slave (of an edge:
// where its rows are made), ordered by key. Kept is what acted in the last step, and the side on which a node meets a
// two-sided face; so the history is a function of the motion alone, whatever the lists held and whenever they were
// made.
#pragma once
#include <array>
#include <span>
#include <vector>

#include "brunt/contact/data/constraint.hpp"
#include "brunt/contact/data/standard_tolerances.hpp"
#include "brunt/core/record_table.hpp"

namespace brunt::contact {

struct HistoryRecord {
  RowKey key{};
  std::array<double, 3> force{};  ///< on the slave: impulse of the row in the last step over its length [force]
  double side = 0;  ///< +1, -1: the side of a two-sided face, along and against its normal; 0 of other rows
};

struct AnchorRecord {
  AnchorKey key{};
  GlobalIndex face = 0;             ///< of a node on a face: key of the one that holds the anchor
  std::array<double, 4> weights{};  ///< of the face's corners at the anchor; of both edges' ends
  std::array<double, 3> on_wall{};  ///< the anchor less the wall's point [length]
};

/// The limit of friction where it lags (see FrictionLaw::lag). The key is that of anchors, so that it stays with a node
/// which slides over to the next face; of several rows of one key it is the mean of those that are pressed, if any is.
struct LimitRecord {
  AnchorKey key{};
  double limit = 0;      ///< after the last step [force]
  bool pressed = false;  ///< was its row, in the step that wrote it? Asked only there: not in checkpoints
};

/// How deep a node lay behind a face that came to the surface in front of it, and how deep it lies now (see
/// contact/births.hpp). The key is that of anchors: node and body of the master.
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

  void clear() {
    pairs.clear();
    anchors.clear();
    limits.clear();
    births.clear();
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

/// Impulses to start the iteration from [momentum]: what the rows, as they are now, admit of the forces of the last
/// step, over a step of length dt. Where a slave has gone over to the next face, its row there starts from the force of
/// the row that it has no more, if that points along the new normal: nodes that rest on an edge between faces change
/// sides at every breath. Zero for rows that did not act. Rows in order.
void start_impulses(std::span<const Row> rows, std::span<const HistoryRecord> records, double dt,
                    std::span<Vec3> impulses, const Tolerances& tolerances = standard_tolerances);

/// The records of a step of length dt: of rows that acted, and of the sides seen (in order of their keys). Allocates
/// nothing where `records` has room for all rows and sides.
void write_pairs(std::span<const Row> rows, std::span<const Vec3> impulses, double dt,
                 std::span<const HistoryRecord> sides, std::vector<HistoryRecord>& records);

/// The history as tables for checkpoints and the state hash, and back.
using HistoryTables = std::array<RecordTable, 4>;
void to_tables(const History& history, HistoryTables& tables);
History from_tables(const HistoryTables& tables);

}  // namespace brunt::contact
