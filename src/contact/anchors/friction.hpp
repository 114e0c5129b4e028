// SPDX-License-Identifier: Apache-2.0
// Friction of rows: its coefficient, its lag behind the pressure, and the anchors of sticking nodes. A sticking node
// has an anchor on its face (or wall). The rate target recovers its drift from the anchor, so sticking nodes do not
// creep. A node that slides drags its anchor along. The anchor is deleted when the node separates or is far from it.
#pragma once
#include <span>
#include <vector>

#include "contact/anchors/anchors.hpp"
#include "contact/data/history.hpp"
#include "contact/data/options.hpp"

namespace brunt::contact {

/// The coefficient of the law at the slip rate of the row's nodes before the step; v at n - 1/2.
double friction_coefficient(const FrictionLaw& law, const Row& row, std::span<const NodeMotion> motion);

/// Sets the friction of the row if it lags: the pressure of this step enters with dt / (dt + lag) (backward Euler), and
/// the remainder is the previous limit, which is 0 for a row without a record. limits: in order of their keys.
void let_friction_lag(Row& row, std::span<const LimitRecord> limits, double lag, double dt);

/// The limits after a step with these impulses, in order of their keys, for lagging rows from their first pressure as
/// long as they exist. Does not allocate if `after` has room for all rows.
void write_limits(std::span<const Row> rows, std::span<const Vec3> impulses, double dt,
                  std::vector<LimitRecord>& after);

struct AnchorSettings {
  double recovery = 0;  ///< share of the distance to the anchor that is recovered in a step
  double limit = 0;     ///< upper bound of this recovery [length]
};

/// Row::drift and its share of the slip, for rows with friction whose slave stuck in the last step. anchors: in order
/// of their keys.
void aim_at_anchors(std::span<Row> rows, const AnchorScene& scene, std::span<const AnchorRecord> anchors,
                    const AnchorSettings& settings, double dt);

/// The anchors after a step with these impulses, in order of their keys. Sticking nodes keep their anchors; if a node
/// has just come to rest, its contact point becomes the anchor. Nodes at their limit drag them along, by what they
/// slid: where loads are shared among redundant rows, a body that sticks has rows at their limits that slide by
/// nothing. slid: of each row with friction, what it moves within the step against its target [length]. Does not
/// allocate if `after` has room for all rows.
void write_anchors(std::span<const Row> rows, std::span<const Vec3> impulses, std::span<const Vec3> slid,
                   const AnchorScene& scene, std::span<const AnchorRecord> before, std::vector<AnchorRecord>& after);

}  // namespace brunt::contact
