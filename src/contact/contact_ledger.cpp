// SPDX-License-Identifier: Apache-2.0
// What contact books: work and impulses of its last step, and their sums over the run.
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "brunt/contact/contact.hpp"

namespace brunt::contact {
namespace {

void add_vector(std::array<comm::ExactAccumulator, 3>& sum, const Vec3& value) {
  for (std::size_t c = 0; c < 3; ++c) sum[c].add(value[static_cast<int>(c)]);
}

}  // namespace

bool Contact::is_slave_in(const Row& row, std::int32_t block) const {
  if (row.is_edge()) return row.slave_block == block;
  const LocalIndex slave = lists_.nodes.surface_node[static_cast<std::size_t>(row.nodes[0])];
  const auto blocks = surface_.blocks.row(slave);
  return std::binary_search(blocks.begin(), blocks.end(), block);
}

/// Takes what impulses do at these relative velocities from the sums: half of p . r along the normal, the rest across.
void Contact::book_work(const Row& row, const Vec3& impulse, const Vec3& relative, WorkSums& sums) {
  const double push = row.normal.dot(impulse);
  (row.is_wall() ? sums.walls : sums.contact).add(-0.5 * push * row.normal.dot(relative));
  if (row.friction > 0) sums.friction.add(-0.5 * (impulse - push * row.normal).dot(relative));
  if (std::isinf(row.friction)) [[unlikely]]
    sums.ties.add(-0.5 * (impulse - push * row.normal).dot(relative));
}

void Contact::book() {
  for (std::size_t q = 0; q < rows_.size(); ++q) {
    const Vec3& impulse = impulses_[q];
    if (impulse.isZero(0)) continue;
    const Row& row = rows_[q];
    const auto old_velocity = [&](LocalIndex node) -> const Vec3& {
      return motion_of_[static_cast<std::size_t>(node)].old_velocity;
    };
    const Vec3 relative = relative_velocity(row, velocity_) + relative_motion(row, old_velocity);
    book_work(row, impulse, relative, sums_.work);
    if (row.is_wall()) {
      add_vector(sums_.wall_impulse[static_cast<std::size_t>(-1 - row.master_key)], impulse);
      continue;
    }
    const auto place = [&](std::size_t i) -> const Vec3& {
      return motion_of_[static_cast<std::size_t>(row.nodes[i])].position;
    };
    Vec3 spin = Vec3::Zero();  // about the slave: what the nodes take sums to zero
    for (std::size_t i = 1; i < static_cast<std::size_t>(row.node_count); ++i)
      spin += (place(i) - place(0)).cross(impulse_on_node(row, i, impulse));
    add_vector(sums_.spin, spin);
    sums_.push.add(impulse.norm());
    for (std::size_t t = 0; t < settings_.tracked.size(); ++t) {
      const auto [first, second] = settings_.tracked[t];
      const auto slave_in = [&](std::int32_t block) { return is_slave_in(row, block); };
      if (slave_in(first) && row.master_block == second)
        add_vector(sums_.tracked_impulse[t], impulse);
      else if (slave_in(second) && row.master_block == first)
        add_vector(sums_.tracked_impulse[t], -impulse);
    }
  }
}

void Contact::add_second_half(WorkSums& half) const {
  for (std::size_t q = 0; q < rows_.size(); ++q)
    if (!impulses_[q].isZero(0)) book_work(rows_[q], impulses_[q], relative_velocity(rows_[q], velocity_), half);
}

void Contact::add_impulses(std::span<Vec3> impulse) const {
  if (!statistics_.last.acted) return;
  for (std::size_t i = 0; i < lists_.nodes.gid.size(); ++i) {
    if (lists_.nodes.home[i].rank != ranks_.rank()) continue;
    const LocalIndex node = surface_.model_node[static_cast<std::size_t>(lists_.nodes.surface_node[i])];
    impulse[static_cast<std::size_t>(node)] += impulse_of_node(scratch_, i);
  }
}

RubbingRow Contact::most_given_by_friction() const {
  RubbingRow most;
  for (std::size_t q = 0; q < rows_.size(); ++q) {
    const Row& row = rows_[q];
    if (!(row.friction > 0) || std::isinf(row.friction) || impulses_[q].isZero(0)) continue;
    const auto old_velocity = [&](LocalIndex node) -> const Vec3& {
      return motion_of_[static_cast<std::size_t>(node)].old_velocity;
    };
    const Vec3 across = impulses_[q] - row.normal.dot(impulses_[q]) * row.normal;
    const double work = -0.5 * across.dot(relative_velocity(row, velocity_) + relative_motion(row, old_velocity));
    if (most.slave_gid == no_index || work < most.work)
      most = {work, row.slave_gid, motion_of_[static_cast<std::size_t>(row.nodes[0])].position, row.master_block};
  }
  return most;
}

/// C p^2 / 2 of each, as springs (see enforcement/softness.hpp).
comm::ExactAccumulator Contact::stored_in_soft_rows() const {
  comm::ExactAccumulator stored;
  if (!statistics_.last.acted) return stored;
  for (std::size_t q = 0; q < rows_.size(); ++q)
    if (rows_[q].softness > 0) stored.add(0.5 * scratch_.compliance[q] * impulses_[q].squaredNorm());
  return stored;
}

ContactTotals Contact::collect() const {
  std::vector<comm::ExactAccumulator> sums{sums_.work.contact, sums_.work.friction, sums_.work.walls, sums_.work.ties};
  sums.insert(sums.end(), sums_.spin.begin(), sums_.spin.end());
  sums.push_back(sums_.push);
  sums.push_back(stored_in_soft_rows());
  for (const auto* vectors : {&sums_.wall_impulse, &sums_.tracked_impulse})
    for (const auto& vector : *vectors) sums.insert(sums.end(), vector.begin(), vector.end());
  std::vector<double> totals(sums.size());
  comm::exact_sum(ranks_, sums, totals);

  ContactTotals result;
  result.contact_work = totals[0];
  result.friction_work = totals[1];
  result.wall_work = totals[2];
  result.tie_work = totals[3];
  result.spin = Vec3(&totals[4]);
  result.push = totals[7];
  result.stored = totals[8];
  std::size_t next = 9;
  for (auto [count, vectors] : {std::pair{sums_.wall_impulse.size(), &result.wall_impulse},
                                std::pair{sums_.tracked_impulse.size(), &result.tracked_impulse}})
    for (std::size_t i = 0; i < count; ++i, next += 3) vectors->push_back(Vec3(&totals[next]));
  result.pairs = ranks_.sum(static_cast<GlobalIndex>(lists_.candidates.faces.values.size()));
  result.active = ranks_.sum(static_cast<GlobalIndex>(
      std::count_if(impulses_.begin(), impulses_.end(), [](const Vec3& impulse) { return !impulse.isZero(0); })));
  GlobalIndex touching = 0;
  for (std::size_t q = 0; q < rows_.size(); ++q)
    if (!impulses_[q].isZero(0) && !rows_[q].is_wall() && !std::isinf(rows_[q].friction)) ++touching;
  result.touching = ranks_.sum(touching);
  result.penetration = ranks_.max(sums_.penetration);
  return result;
}

}  // namespace brunt::contact
