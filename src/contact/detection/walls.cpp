// SPDX-License-Identifier: Apache-2.0
// Node against rigid wall.
#include <algorithm>

#include "contact/data/tolerances.hpp"
#include "contact/detection/detection.hpp"

namespace brunt::contact {

void detect_walls(const StepView& step, std::span<const WallCandidate> candidates, std::span<const Wall> walls,
                  std::vector<Row>& rows) {
  const DetectionSettings& settings = step.settings;
  for (const WallCandidate& candidate : candidates) {
    const Wall& wall = nth(walls, candidate.wall);
    const NodeMotion& node = nth(step.motion, candidate.node);
    const double gap = (node.position - wall.point).dot(wall.normal);
    const double wall_rate = wall.velocity.dot(wall.normal);
    const double next_gap = gap + step.dt * (node.predicted.dot(wall.normal) - wall_rate);
    const bool held = wall.bilateral && candidate.held;
    if (!held && std::min(gap, next_gap) > settings.tolerances->capture * settings.wall_size) continue;
    const bool closed = held || gap < 0;
    const double limit = settings.tolerances->recovery_limit * settings.wall_size;
    const double recovery = std::clamp(-settings.tolerances->recovery * gap, -limit, limit);
    Row row{.key = {.kind = RowKind::wall, .slave = nth(step.gid, candidate.node), .master = candidate.wall}};
    row.nodes[0] = candidate.node;
    row.weights[0] = 1;
    row.node_count = 1;
    row.slave_body = candidate.body;
    row.normal = wall.normal;
    row.gap = gap;
    row.wall_rate = wall_rate;
    row.required =
        wall_rate + (closed ? recovery / recovery_time(row, settings.wall_size, step.dt, settings) : -gap / step.dt);
    row.cone = held ? Cone::free : Cone::compression;
    rows.push_back(row);
  }
}

}  // namespace brunt::contact
