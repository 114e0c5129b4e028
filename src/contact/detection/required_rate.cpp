// SPDX-License-Identifier: Apache-2.0
// The rate that a row requires of its gap, and the overlaps of the start from which gaps are measured.
#include <algorithm>
#include <utility>

#include "contact/data/tolerances.hpp"
#include "contact/detection/detection.hpp"

namespace brunt::contact {
namespace {

bool are_fitted(std::span<const BodyPair> fitted, const Row& row) {
  return std::ranges::binary_search(fitted, BodyPair(std::minmax(row.slave_body, row.master_body)));
}

}  // namespace

double accepted_penetration(std::span<const AcceptedOverlap> accepted, GlobalIndex slave, std::int32_t body) {
  if (accepted.empty()) return 0;
  const auto before = [](const AcceptedOverlap& one, const std::pair<GlobalIndex, std::int32_t>& wanted) {
    return std::pair(one.slave, one.body) < wanted;
  };
  const auto found = std::lower_bound(accepted.begin(), accepted.end(), std::pair(slave, body), before);
  return found != accepted.end() && found->slave == slave && found->body == body ? found->penetration : 0;
}

double recovery_time(const Row& row, double size, double dt, const DetectionSettings& settings) {
  const std::vector<double>& sound = settings.sound;
  if (sound.empty()) return dt;
  double slower = nth(sound, row.slave_body);
  if (!row.is_wall()) slower = std::min(slower, nth(sound, row.master_body));
  return std::max(dt, settings.tolerances->recovery_time * size / slower);
}

double required_rate(const Row& row, double gap, double size, const StepView& step) {
  if (gap >= 0) return -gap / step.dt;
  const DetectionSettings& settings = step.settings;
  const Tolerances& tolerances = *settings.tolerances;
  const double time = recovery_time(row, size, step.dt, settings);
  const double recovery = std::min(-tolerances.recovery * gap, tolerances.recovery_limit * size) / time;
  const bool fitted = are_fitted(settings.fitted, row);
  if (!fitted && (settings.recovery_gives || !row.is_edge())) return recovery;
  if (-gap <= (fitted ? tolerances.touching : tolerances.drift) * size) return recovery;
  const Vec3 relative =
      relative_velocity(row, [&](LocalIndex node) -> const Vec3& { return nth(step.motion, node).old_velocity; });
  return std::clamp(-row.normal.dot(relative), 0.0, recovery);
}

}  // namespace brunt::contact
