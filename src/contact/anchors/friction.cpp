// SPDX-License-Identifier: Apache-2.0
#include "contact/anchors/friction.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "contact/data/tolerances.hpp"

namespace brunt::contact {
namespace {

/// Not a tie, which keeps its place by itself, nor a mortar row, which counts its slip.
bool has_anchor(const Row& row) {
  return row.friction > 0 && !row.is_mortar();
}

bool sticks(const Row& row, const Vec3& impulse, const Tolerances& tolerances) {
  const double inside = 1 - tolerances.fine_rounding;
  const double push = row.normal.dot(impulse);
  return push > 0 && (impulse - push * row.normal).norm() < inside * friction_limit(row, push);
}

/// The anchors of rows, which mostly come in the order of their slaves, as anchors do.
class AnchorsInOrder {
 public:
  explicit AnchorsInOrder(std::span<const AnchorRecord> anchors) : anchors_(anchors) {}
  /// Null if the row has none.
  const AnchorRecord* of(const Row& row) {
    const AnchorKey key = anchor_key_of(row);
    if (key.slave < slave_) next_ = 0;
    slave_ = key.slave;
    while (next_ < anchors_.size() && anchors_[next_].key.slave < slave_) ++next_;
    for (std::size_t i = next_; i < anchors_.size() && anchors_[i].key.slave == slave_; ++i)
      if (anchors_[i].key == key) return &anchors_[i];
    return nullptr;
  }

 private:
  std::span<const AnchorRecord> anchors_;
  std::size_t next_ = 0;
  GlobalIndex slave_ = 0;
};

/// Ascending, each key once.
bool are_in_order(std::span<const AnchorRecord> anchors) {
  const auto not_before = [](const AnchorRecord& a, const AnchorRecord& b) { return !(a.key < b.key); };
  return std::ranges::adjacent_find(anchors, not_before) == anchors.end();
}

}  // namespace

double friction_coefficient(const FrictionLaw& law, const Row& row, std::span<const NodeMotion> motion) {
  if (law.decay == 0 || law.fixed == law.kinetic) return law.fixed;
  Vec3 slip = Vec3::Zero();
  for (std::size_t i = 0; i < row.points().size(); ++i)
    slip += row.shares()[i] * nth(motion, row.points()[i]).old_velocity;
  slip -= row.normal.dot(slip) * row.normal;
  return law.coefficient(slip.norm());
}

void let_friction_lag(Row& row, std::span<const LimitRecord> limits, double lag, double dt) {
  row.lags = true;
  const AnchorKey key = anchor_key_of(row);
  const auto found = std::ranges::lower_bound(limits, key, {}, &LimitRecord::key);
  row.friction *= dt / (dt + lag);
  if (found != limits.end() && found->key == key) row.lagging = lag / (dt + lag) * found->limit * dt;
}

void write_limits(std::span<const Row> rows, std::span<const Vec3> impulses, double dt,
                  std::vector<LimitRecord>& after) {
  after.clear();
  for (std::size_t q = 0; q < rows.size(); ++q) {
    if (!rows[q].lags) continue;
    const double push = std::max(0.0, rows[q].normal.dot(impulses[q]));
    const double limit = friction_limit(rows[q], push) / dt;
    if (limit > 0) after.push_back({anchor_key_of(rows[q]), limit, push > 0});
  }
  const auto order = [](const LimitRecord& record) { return std::tuple(record.key, !record.pressed, record.limit); };
  std::ranges::sort(after, {}, order);
  auto kept = after.begin();
  for (auto first = after.begin(), end = first; first != after.end();) {
    double sum = 0;
    for (end = first; end != after.end() && end->key == first->key && end->pressed == first->pressed; ++end)
      sum += end->limit;
    *kept = {first->key, sum / static_cast<double>(end - first), first->pressed};
    const AnchorKey key = kept++->key;
    for (first = end; first != after.end() && first->key == key;) ++first;  // rows that are not pressed
  }
  after.erase(kept, after.end());
}

void aim_at_anchors(std::span<Row> rows, const AnchorScene& scene, std::span<const AnchorRecord> anchors,
                    const AnchorSettings& settings, double dt) {
  if (anchors.empty()) return;
  AnchorsInOrder in_order(anchors);
  for (Row& row : rows) {
    if (!has_anchor(row)) continue;
    const AnchorRecord* anchor = in_order.of(row);
    const std::optional<Vec3> crept = anchor ? slip(scene, *anchor, row) : std::nullopt;
    if (!crept) continue;
    const Vec3 across = *crept - row.normal.dot(*crept) * row.normal;
    const double size = across.norm();
    if (size == 0) continue;
    row.drift_share = std::min(settings.recovery, settings.limit / size);
    row.drift = -row.drift_share / dt * across;
  }
}

void write_anchors(std::span<const Row> rows, std::span<const Vec3> impulses, std::span<const Vec3> slid,
                   const AnchorScene& scene, std::span<const AnchorRecord> before, std::vector<AnchorRecord>& after) {
  after.clear();
  AnchorsInOrder in_order(before);
  for (std::size_t q = 0; q < rows.size(); ++q) {
    const Row& row = rows[q];
    if (!has_anchor(row) || !(row.normal.dot(impulses[q]) > 0)) continue;
    const AnchorRecord* anchor = in_order.of(row);
    if (anchor != nullptr && !slip(scene, *anchor, row)) anchor = nullptr;  // out of its reach
    if (sticks(row, impulses[q], *scene.tolerances))
      after.push_back(anchor != nullptr ? *anchor : anchor_of(scene, row));
    else if (anchor != nullptr)
      if (const auto moved = dragged(scene, *anchor, row, slid[q])) after.push_back(*moved);
  }
  if (are_in_order(after)) return;
  // several faces of one body may hold a node: the one of the lowest key is its anchor, of two rows that drag the same
  // one the first in the order of its places, since the order of rows is not that of other ranks
  const auto whole = [](const AnchorRecord& record) {
    return std::tuple(record.key, record.face, record.weights, record.on_wall);
  };
  std::ranges::sort(after, {}, whole);
  const auto same = [](const AnchorRecord& a, const AnchorRecord& b) { return a.key == b.key; };
  after.erase(std::unique(after.begin(), after.end(), same), after.end());
}

}  // namespace brunt::contact
