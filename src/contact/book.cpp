// SPDX-License-Identifier: Apache-2.0
#include "book.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "book_tracked.hpp"

namespace brunt::contact {
namespace {

void add_vector(std::array<comm::ExactAccumulator, 3>& sum, const Vec3& value) {
  for (std::size_t c = 0; c < 3; ++c) sum[c].add(value[static_cast<int>(c)]);
}

/// Subtracts the work of impulses at these relative velocities from the sums: half of p . r along the normal, the
/// remainder across it. unmet: the row cannot be satisfied.
void book_work(const Row& row, bool unmet, const Vec3& impulse, const Vec3& relative, WorkSums& sums) {
  const double push = row.normal.dot(impulse);
  (unmet ? sums.driven : row.is_wall() ? sums.walls : sums.contact).add(-0.5 * push * row.normal.dot(relative));
  if (row.friction > 0 || row.holds) sums.friction.add(-0.5 * (impulse - push * row.normal).dot(relative));
  if (row.holds) [[unlikely]]
    sums.ties.add(-0.5 * (impulse - push * row.normal).dot(relative));
}

/// Before and after the step, added up.
Vec3 both_relative_velocities(const ContactNodes& nodes, const Row& row) {
  const auto old_velocity = [&](LocalIndex node) -> const Vec3& { return nth(nodes.motion, node).old_velocity; };
  return relative_velocity(row, nodes.velocity) + relative_velocity(row, old_velocity);
}

/// About the slave: the impulses on the nodes sum to zero.
Vec3 spin_of(const ContactNodes& nodes, const Row& row, const Vec3& impulse) {
  const auto place = [&](std::size_t i) -> const Vec3& { return nth(nodes.motion, row.points()[i]).position; };
  Vec3 spin = Vec3::Zero();
  for (std::size_t i = 1; i < row.points().size(); ++i)
    spin += (place(i) - place(0)).cross(impulse_on_node(row, i, impulse));
  return spin;
}

/// C p^2 / 2 of each row, as for springs (see enforcement/softness.hpp).
comm::ExactAccumulator stored_in_soft_rows(const Contact& contact) {
  const StepData& step = contact.step;
  comm::ExactAccumulator stored;
  if (!contact.ledger.statistics.last.acted) return stored;
  for (std::size_t q = 0; q < step.rows.size(); ++q)
    if (step.rows[q].softness > 0)
      stored.add(0.5 * step.scratch.enforcement.compliance[q] * step.impulses[q].squaredNorm());
  return stored;
}

}  // namespace

void book_iterations(const EnforcementResult& result, const EnforcementSettings& settings, bool can_be_met,
                     ContactStatistics& statistics) {
  statistics.last = result;
  if (!result.acted) return;
  ++statistics.solved_steps;
  statistics.iterations += result.iterations;
  statistics.most_iterations = std::max(statistics.most_iterations, result.iterations);
  statistics.largest_residual = std::max(statistics.largest_residual, result.residual);
  if (can_be_met && ended_at_limit(result, settings)) ++statistics.steps_at_limit;
  if (result.scaled_islands > 0) ++statistics.scaled_steps;
  statistics.least_share = std::min(statistics.least_share, result.least_share);
}

void book_impulses(Contact& contact) {
  const StepData& step = contact.step;
  ContactSums& sums = contact.ledger.sums;
  for (std::size_t q = 0; q < step.rows.size(); ++q) {
    const Vec3& impulse = step.impulses[q];
    if (impulse.isZero(0)) continue;
    const Row& row = step.rows[q];
    book_work(row, contact.unmet.is(q), impulse, both_relative_velocities(step.nodes, row), sums.work);
    if (row.is_wall()) {
      add_vector(nth(sums.wall_impulse, row.key.master), impulse);
      continue;
    }
    add_vector(sums.spin, spin_of(step.nodes, row, impulse));
    sums.push.add(impulse.norm());
    book_tracked(contact, row, impulse);
  }
}

void add_second_half(const Contact& contact, WorkSums& half) {
  const StepData& step = contact.step;
  for (std::size_t q = 0; q < step.rows.size(); ++q)
    if (!step.impulses[q].isZero(0))
      book_work(step.rows[q], contact.unmet.is(q), step.impulses[q],
                relative_velocity(step.rows[q], step.nodes.velocity), half);
}

void add_impulses(const Contact& contact, std::span<Vec3> impulse) {
  if (!contact.ledger.statistics.last.acted) return;
  const NodeTable& nodes = contact.lists.nodes;
  for (std::size_t i = 0; i < nodes.gid.size(); ++i) {
    if (nodes.home[i].rank != contact.ranks.rank()) continue;
    const LocalIndex node = nth(contact.surface.model_node, nodes.surface_node[i]);
    nth(impulse, node) += impulse_of_node(contact.step.scratch.enforcement, i);
  }
}

RubbingRow most_given_by_friction(const Contact& contact) {
  const StepData& step = contact.step;
  RubbingRow most;
  for (std::size_t q = 0; q < step.rows.size(); ++q) {
    const Row& row = step.rows[q];
    const Vec3& impulse = step.impulses[q];
    if (!(row.friction > 0) || impulse.isZero(0)) continue;
    const Vec3 across = impulse - row.normal.dot(impulse) * row.normal;
    const double work = -0.5 * across.dot(both_relative_velocities(step.nodes, row));
    if (most.slave_gid == no_index || work < most.work)
      most = {work, row.key.slave, nth(step.nodes.motion, row.nodes[0]).position,
              row.is_wall() ? no_index : row.master_block};
  }
  return most;
}

ContactTotals collect(const Contact& contact) {
  const comm::Communicator& ranks = contact.ranks;
  const ContactSums& own = contact.ledger.sums;
  std::vector<comm::ExactAccumulator> sums{own.work.contact, own.work.friction, own.work.walls, own.work.ties,
                                           own.work.driven};
  sums.insert(sums.end(), own.spin.begin(), own.spin.end());
  sums.push_back(own.push);
  sums.push_back(stored_in_soft_rows(contact));
  for (const auto& vector : own.wall_impulse) sums.insert(sums.end(), vector.begin(), vector.end());
  for (const TrackedSums& tracked : own.tracked) append(tracked, sums);
  std::vector<double> totals(sums.size());
  comm::exact_sum(ranks, sums, totals);

  ContactTotals result;
  result.contact_work = totals[0];
  result.friction_work = totals[1];
  result.wall_work = totals[2];
  result.tie_work = totals[3];
  result.driven_work = totals[4];
  result.spin = Vec3(&totals[5]);
  result.push = totals[8];
  result.stored = totals[9];
  std::size_t next = 10;
  for (std::size_t w = 0; w < own.wall_impulse.size(); ++w, next += 3)
    result.wall_impulse.push_back(Vec3(&totals[next]));
  for (std::size_t t = 0; t < own.tracked.size(); ++t, next += tracked_width)
    result.tracked.push_back(tracked_totals(std::span(totals).subspan(next).first<tracked_width>()));
  result.pairs = ranks.sum(static_cast<GlobalIndex>(contact.lists.candidates.faces.values.size()));
  GlobalIndex active = 0, touching = 0;
  for (std::size_t q = 0; q < contact.step.rows.size(); ++q) {
    if (contact.step.impulses[q].isZero(0)) continue;
    ++active;
    const Row& row = contact.step.rows[q];
    if (!row.is_wall() && !row.holds) ++touching;
  }
  result.active = ranks.sum(active);
  result.touching = ranks.sum(touching);
  result.penetration = ranks.max(own.penetration);
  return result;
}

}  // namespace brunt::contact
