// SPDX-License-Identifier: Apache-2.0
// What friction adds to rows: its coefficient, what it lags behind the pressure by, and where a node that sticks holds
// on. A sticking node has an anchor on its face (or wall); what it has crept away from it is asked back by the rate
// target, so that nothing drifts however many steps it sticks. The anchor goes where the node slides or lifts off, or
// is far from it (see `slip`).
#pragma once
#include <span>
#include <vector>

#include "brunt/contact/anchors.hpp"
#include "brunt/contact/data/history.hpp"
#include "brunt/contact/data/options.hpp"

namespace brunt::contact {

/// The law's coefficient at the slip rate that the row's nodes had before the step; v at n - 1/2.
double friction_coefficient(const FrictionLaw& law, const Row& row, std::span<const NodeMotion> motion);

/// Gives the row its friction where it lags: the step's own pressure counts by dt / (dt + lag) (backward Euler), the
/// rest is the limit of before, which is 0 for a row without a record. limits: in order of their keys.
void let_friction_lag(Row& row, std::span<const LimitRecord> limits, double lag, double dt);

/// The limits after a step with these impulses, in order of their keys: of rows that lag, as soon as they are pressed
/// and for as long as they are there. Allocates nothing where `after` has room for all rows.
void write_limits(std::span<const Row> rows, std::span<const Vec3> impulses, double dt,
                  std::vector<LimitRecord>& after);

struct AnchorSettings {
  double recovery = 0;  ///< share of the distance to the anchor that a step takes back
  double limit = 0;     ///< the same at most [length]
};

/// Row::drift and its share of the slip, of rows with friction whose slave stuck in the last step. anchors: in order of
/// their keys.
void aim_at_anchors(std::span<Row> rows, const AnchorScene& scene, std::span<const AnchorRecord> anchors,
                    const AnchorSettings& settings, double dt);

/// The anchors after a step with these impulses, in order of their keys: of nodes that stick, those of before or, where
/// they have just come to rest, the points that they touch. Edges have none. Allocates nothing where `after` has room
/// for all rows.
void write_anchors(std::span<const Row> rows, std::span<const Vec3> impulses, const AnchorScene& scene,
                   std::span<const AnchorRecord> before, std::vector<AnchorRecord>& after);

}  // namespace brunt::contact
