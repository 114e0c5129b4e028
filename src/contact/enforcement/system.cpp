// SPDX-License-Identifier: Apache-2.0
#include "contact/enforcement/system.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/error.hpp"
#include "impulse_grid.hpp"

namespace brunt::contact {
namespace {

using Counts = bool (*)(const RowMatrix&, std::size_t);

/// Share of an impulse along the row's directions that the node is free to follow: unless it slips any direction
/// counts. length: of the row's normal.
double free_share(const RowLaw& law, double length, const Mobility& mobility) {
  if (mobility.is_free()) return law.across != Across::slips ? 1.0 : length;
  if (law.across != Across::slips) return mobility.projector.norm() > Mobility::rounding ? 1.0 : 0.0;
  const double along = (mobility.projector * law.normal).norm();
  return along > Mobility::rounding ? along : 0.0;
}

/// |G_qn P_n| of an entry of row q (of an arm: a bound of it).
double weight_of(const RowMatrix& rows, std::size_t q, std::size_t entry, double length, const Mobility& mobility) {
  const RowLaw& law = rows.laws[q];
  double weight = std::abs(rows.weights[entry]);
  if (law.turns) weight += rows.arm(q, entry).size;
  if (law.tilts) weight += rows.tilt(q, entry).norm();
  return weight * free_share(law, length, mobility);
}

/// Whether an impulse in this row can change its rate. Otherwise the row is ignored: prescribed motion takes
/// precedence. (Coulomb friction requires a pressure: it is zero if both sides are constrained along the normal.)
bool can_act(const System& system, std::size_t q) {
  const RowMatrix& rows = system.rows;
  const RowLaw& law = rows.laws[q];
  const double length = law.normal.norm();
  for (std::size_t k = rows.begin(q); k < rows.end(q); ++k) {
    const Mobility& mobility = system.mobility[rows.point(k)];
    if (mobility.inverse_mass > 0 && weight_of(rows, q, k, length, mobility) > 0 &&
        (law.across == Across::holds || mobility.is_free_along(law.normal)))
      return true;
  }
  for (const BodyShare& share : rows.bodies_of(q))
    if (share.along > 0 || (law.across == Across::holds && share.weight > 0)) return true;
  return false;
}

double shortfall(const RowLaw& law, const Vec3& relative) {
  if (law.across == Across::holds) return missing_rate(law, relative).norm();
  const double missing = law.required - law.normal.dot(relative);
  return law.cone == Cone::compression ? std::max(missing, 0.0) : std::abs(missing);
}

void lay_weights_on_bodies(const RowMatrix& rows, std::size_t q, CarriedScratch& scratch) {
  const std::vector<LocalIndex>& offsets = rows.on_bodies.offsets;
  for (auto i = static_cast<std::size_t>(offsets[q]); i < static_cast<std::size_t>(offsets[q + 1]); ++i)
    scratch.share[i] = rows.on_bodies.values[i].weight;
}

/// Adds what bodies have of H_q. Do others share them, or is the row's own part a bound?
bool add_bodies_to_diagonal(const RowMatrix& rows, std::size_t q, EnforcementScratch& scratch) {
  bool coupled = false;
  const std::vector<LocalIndex>& offsets = rows.on_bodies.offsets;
  for (auto i = static_cast<std::size_t>(offsets[q]); i < static_cast<std::size_t>(offsets[q + 1]); ++i) {
    const double weight = scratch.carried.share[i];
    const BodyShare& share = rows.on_bodies.values[i];
    const double sum =
        scratch.carried
            .row_sum[body_groups * static_cast<std::size_t>(share.body) + static_cast<std::size_t>(share.group)];
    coupled = coupled || (weight > 0 && (sum != weight || rows.laws[q].across != Across::slips));
    scratch.diagonal[q] += weight * sum;
  }
  return coupled;
}

/// Weights of this rank's rows, laid on their points; scratch.share keeps them.
void lay_weights(const System& system, EnforcementScratch& scratch, Counts counts) {
  const RowMatrix& rows = system.rows;
  const BinGrid grid = BinGrid::for_bound(RowMatrix::largest_weight);
  scratch.row_sum_parts.assign(system.motion.size() * row_sum_width, 0.0);
  scratch.share.assign(rows.entries(), 0.0);
  scratch.carried.share.assign(rows.on_bodies.values.size(), 0.0);
  for (std::size_t q = 0; q < rows.size(); ++q) {
    if ((counts != nullptr && !counts(rows, q)) || !can_act(system, q)) continue;
    const double length = rows.laws[q].normal.norm();
    for (std::size_t k = rows.begin(q); k < rows.end(q); ++k) {
      const std::size_t node = rows.point(k);
      const double weight = weight_of(rows, q, k, length, system.mobility[node]);
      scratch.share[k] = weight;
      double* parts = &scratch.row_sum_parts[node * row_sum_width];
      binned_add(grid, weight, parts);
      parts[bin_slices] += 1;
    }
    if (rows.has_bodies()) lay_weights_on_bodies(rows, q, scratch.carried);
  }
}

/// From the parts, on owners.
void take_row_sums(EnforcementScratch& scratch) {
  scratch.row_sum.resize(scratch.row_sum_parts.size() / row_sum_width);
  for (std::size_t node = 0; node < scratch.row_sum.size(); ++node) {
    const double* parts = &scratch.row_sum_parts[node * row_sum_width];
    demand(parts[bin_slices] <= binned_terms, "the sums of a contact node have room for all its rows");
    scratch.row_sum[node] = binned_value(parts);
  }
}

/// From the row sums of all nodes; see form_row_sums.
bool lay_diagonal(const System& system, EnforcementScratch& scratch, Counts counts) {
  const RowMatrix& rows = system.rows;
  scratch.diagonal.assign(rows.size(), 0.0);
  bool coupled = false;
  for (std::size_t q = 0; q < rows.size(); ++q) {
    if (counts != nullptr && !counts(rows, q)) continue;
    const RowLaw& law = rows.laws[q];
    coupled = coupled || law.turns || law.tilts;  // its H is a bound
    for (std::size_t k = rows.begin(q); k < rows.end(q); ++k) {
      const Mobility& mobility = system.mobility[rows.point(k)];
      const double weight = scratch.share[k], sum = scratch.row_sum[rows.point(k)];
      if (mobility.inverse_mass > 0 && weight > 0)
        coupled = coupled || sum != weight || (law.across != Across::slips && !mobility.projector.isIdentity(0));
      scratch.diagonal[q] += weight * sum * (system.mobility_scale * mobility.inverse_mass);
    }
    if (rows.has_bodies() && add_bodies_to_diagonal(rows, q, scratch)) coupled = true;
    for (const BodyShare& share : rows.bodies_of(q))  // with joints the weight is a bound
      coupled = coupled || (share.weight > 0 && system.carriers.group_of(share.body) != nullptr);
  }
  return coupled;
}

/// Impulses of this rank's rows, laid on their points.
void lay_impulses(const System& system, std::span<const Vec3> impulses, double largest, EnforcementScratch& scratch) {
  const RowMatrix& rows = system.rows;
  const ImpulseGrid grid(BinGrid::for_bound(largest));
  scratch.impulse_parts.assign(system.motion.size() * impulse_width, 0.0);
  for (std::size_t q = 0; q < rows.size(); ++q) {
    if (impulses[q].isZero(0)) continue;
    const auto parts_of = [&](std::size_t k) { return &scratch.impulse_parts[rows.point(k) * impulse_width]; };
    if (rows.laws[q].turns) [[unlikely]] {
      for (std::size_t k = rows.begin(q); k < rows.end(q); ++k)
        grid.add(impulse_on_point(rows, q, k, impulses[q]), parts_of(k));
      continue;
    }
    const Quad impulse{impulses[q][0], impulses[q][1], impulses[q][2], 0};
    if (rows.laws[q].tilts) {
      const Vec3& n = rows.laws[q].normal;
      const Quad normal{n[0], n[1], n[2], 0};
      for (std::size_t k = rows.begin(q); k < rows.end(q); ++k)
        grid.add(rows.weights[k] * impulse + rows.tilt(q, k).dot(impulses[q]) * normal, parts_of(k));
      continue;
    }
    for (std::size_t k = rows.begin(q); k < rows.end(q); ++k) grid.add(rows.weights[k] * impulse, parts_of(k));
  }
}

Vec3 answer(const System& system, std::size_t node, const Vec3& impulse) {
  const Mobility& mobility = system.mobility[node];
  const double inverse_mass = system.mobility_scale * mobility.inverse_mass;
  return mobility.is_free() ? Vec3(inverse_mass * impulse) : Vec3(inverse_mass * (mobility.projector * impulse));
}

/// v = v* + W G^T p, on owners.
void take_velocities(const System& system, const EnforcementScratch& scratch, std::span<Vec3> velocity) {
  for (std::size_t node = 0; node < system.motion.size(); ++node)
    velocity[node] = system.motion[node].predicted + answer(system, node, impulse_of_node(scratch, node));
}

bool has_bodies(const System& system) {
  return !system.carriers.bodies.empty();
}

/// To the velocities that nodes have given, on owners.
void add_answer_of_bodies(const System& system, double largest, Exchange& exchange, std::span<Vec3> velocity,
                          EnforcementScratch& scratch) {
  if (!has_bodies(system)) return;
  contact::add_answer_of_bodies(system.carriers, system.motion, scratch.impulse_parts, largest, exchange, velocity,
                                scratch.carried);
}

NodeValues as_values(std::span<Vec3> velocity) {
  // a rank without nodes takes part all the same
  return {velocity.empty() ? std::span<double>{} : std::span<double>(velocity.front().data(), 3 * velocity.size()), 3};
}

void share_velocities(Exchange& exchange, std::span<Vec3> velocity) {
  const NodeValues values = as_values(velocity);
  exchange.share(values.values, values.width);
}

}  // namespace

void EnforcementScratch::reserve(const RowRoom& room, std::size_t nodes) {
  const std::size_t rows = room.rows;
  diagonal.reserve(rows);
  compliance.reserve(rows);
  share.reserve(room.entries);
  matrix.reserve(rows, room.entries, room.arms, room.tilts);
  previous.reserve(rows);
  for (std::vector<Vec3>* of_rows : {&borne, &missing, &step, &direction, &step_change, &change})
    of_rows->reserve(rows);
  inverse.reserve(rows);
  chosen.reserve(rows);
  row_sum.reserve(nodes);
  row_sum_parts.reserve(nodes * row_sum_width);
  impulse_parts.reserve(nodes * impulse_width);
  packed.reserve(rows, room.points_of_a_row, room.tilts > 0, nodes);
}

void EnforcementScratch::reserve_passes(const RowRoom& room) {
  const std::size_t rows = room.rows;
  pass_rows.reserve(rows, room.entries, room.arms, room.tilts);
  pass_impulses.reserve(rows);
  for (std::vector<Vec3>& impulses : start) impulses.reserve(rows);
  asked.reserve(rows);
}

void EnforcementScratch::reserve_bodies(std::size_t rows, std::size_t nodes, std::size_t bodies) {
  if (bodies == 0) return;
  slide.reserve(rows);
  carried.reserve(rows, nodes, bodies);
  for (RowMatrix* of_rows : {&matrix, &pass_rows}) {
    of_rows->on_bodies.offsets.reserve(rows + 1);
    of_rows->on_bodies.values.reserve(most_bodies_of_a_row * rows);
  }
}

void demand_finite(double largest) {
  if (!std::isfinite(largest))
    throw GuardError(
        "contact: an impulse is not finite; the predicted velocities are not finite, or increased without bound");
}

Vec3 relative_velocity(const Row& row, std::span<const Vec3> velocity) {
  return relative_velocity(row, [&](LocalIndex node) -> const Vec3& { return nth(velocity, node); });
}

Vec3 relative_velocity(const RowMatrix& rows, std::size_t q, std::span<const Vec3> velocity) {
  return relative_velocity(rows, q, [&](LocalIndex node) -> const Vec3& { return nth(velocity, node); });
}

double largest_impulse_on_a_node(const RowMatrix& rows, std::span<const Vec3> impulses) {
  double largest = 0;
  for (std::size_t q = 0; q < rows.size(); ++q) keep_max(largest, rows.laws[q].share * impulses[q].norm());
  return largest;
}

double violation_here(const System& system, std::span<const Vec3> velocity) {
  double largest = 0;
  for (std::size_t q = 0; q < system.rows.size(); ++q) {
    const double missing = shortfall(system.rows.laws[q], relative_velocity(system.rows, q, velocity));
    if (missing != 0 && can_act(system, q)) keep_max(largest, missing);
  }
  return largest;
}

void take_prediction(const System& system, std::span<Vec3> velocity) {
  for (std::size_t node = 0; node < system.motion.size(); ++node) velocity[node] = system.motion[node].predicted;
}

double start_from_prediction(const System& system, Exchange& exchange, std::span<Vec3> velocity) {
  take_prediction(system, velocity);
  double largest = violation_here(system, velocity);
  exchange.max({&largest, 1});
  return largest;
}

bool form_row_sums(const System& system, Exchange& exchange, EnforcementScratch& scratch, Counts counts) {
  lay_weights(system, scratch, counts);
  exchange.sum_to_owner(scratch.row_sum_parts, row_sum_width);
  take_row_sums(scratch);
  exchange.share(scratch.row_sum, 1);
  if (has_bodies(system)) sum_rows_on_bodies(system.rows, exchange, scratch.carried);
  return lay_diagonal(system, scratch, counts);
}

bool start_from_impulses(const System& system, std::span<const Vec3> impulses, double largest, Exchange& exchange,
                         std::span<Vec3> velocity, EnforcementScratch& scratch) {
  lay_weights(system, scratch, nullptr);
  lay_impulses(system, impulses, largest, scratch);
  exchange.sum_both_to_owner({scratch.row_sum_parts, row_sum_width}, {scratch.impulse_parts, impulse_width});
  take_row_sums(scratch);
  take_velocities(system, scratch, velocity);
  add_answer_of_bodies(system, largest, exchange, velocity, scratch);
  if (has_bodies(system)) sum_rows_on_bodies(system.rows, exchange, scratch.carried);
  exchange.share_both({scratch.row_sum, 1}, as_values(velocity.first(system.motion.size())));
  return lay_diagonal(system, scratch, nullptr);
}

void form_diagonal(const System& system, EnforcementScratch& scratch) {
  const RowMatrix& rows = system.rows;
  scratch.diagonal.assign(rows.size(), 0.0);
  for (std::size_t q = 0; q < rows.size(); ++q) {
    const double length = rows.laws[q].normal.norm();
    for (std::size_t k = rows.begin(q); k < rows.end(q); ++k) {
      const Mobility& mobility = system.mobility[rows.point(k)];
      const double weight = weight_of(rows, q, k, length, mobility);
      scratch.diagonal[q] += weight * weight * (system.mobility_scale * mobility.inverse_mass);
    }
    for (const BodyShare& share : rows.bodies_of(q)) scratch.diagonal[q] += share.weight * share.weight;
  }
}

void apply_impulses(const System& system, std::span<const Vec3> impulses, double largest, Exchange& exchange,
                    std::span<Vec3> velocity, EnforcementScratch& scratch) {
  lay_impulses(system, impulses, largest, scratch);
  exchange.sum_to_owner(scratch.impulse_parts, impulse_width);
  take_velocities(system, scratch, velocity);
  add_answer_of_bodies(system, largest, exchange, velocity, scratch);
  share_velocities(exchange, velocity.first(system.motion.size()));
}

void velocities_of_impulses(const System& system, std::span<const Vec3> impulses, double largest, Exchange& exchange,
                            std::span<Vec3> velocity, EnforcementScratch& scratch) {
  lay_impulses(system, impulses, largest, scratch);
  exchange.sum_to_owner(scratch.impulse_parts, impulse_width);
  for (std::size_t node = 0; node < system.motion.size(); ++node)
    velocity[node] = answer(system, node, impulse_of_node(scratch, node));
  add_answer_of_bodies(system, largest, exchange, velocity, scratch);
  share_velocities(exchange, velocity.first(system.motion.size()));
}

}  // namespace brunt::contact
