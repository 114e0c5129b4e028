// SPDX-License-Identifier: Apache-2.0
// What rows remember of an impact with Impact::elastic (contact/enforcement/impact_law.hpp).
#pragma once
#include <span>
#include <vector>

#include "contact/data/constraint.hpp"
#include "core/record_table.hpp"

namespace brunt::contact {

/// Of one row; default: it is open.
struct ImpactState {
  double bank = 0;     ///< B, the energy that it has taken along its normal, less what it has given [energy]
  double pressed = 0;  ///< z_-, force pressing the bodies together in the last step over the impedance [velocity]
  double recent = 0;   ///< phi, the same with a fading memory [velocity]
  double most = 0;     ///< the largest since the arrival [velocity]
  double flow = -1;    ///< e_0, plastic strain of adjacent elements at the arrival; -1: it has not arrived
};

/// It has the key of anchors, so that it remains with a node that slides to the next face.
struct ImpactRecord {
  AnchorKey key{};
  ImpactState state{};
};

/// The states of rows in order of their keys. Rows with one key, of a node at a concave place, share its bank equally.
void read_impacts(std::span<const Row> rows, std::span<const ImpactRecord> records, std::span<ImpactState> states);

/// The records of rows that have arrived, in order of their keys: of rows with one key the sum of the banks and the
/// largest of the rest. Does not allocate if `records` has room for all rows.
void write_impacts(std::span<const Row> rows, std::span<const ImpactState> states, std::vector<ImpactRecord>& records);

/// For checkpoints and the state hash.
RecordTable impact_table(std::span<const ImpactRecord> records);
std::vector<ImpactRecord> impacts_from(const RecordTable& table);

}  // namespace brunt::contact
