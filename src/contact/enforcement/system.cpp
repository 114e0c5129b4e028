// SPDX-License-Identifier: Apache-2.0
#include "brunt/contact/enforcement/system.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

#include "brunt/core/error.hpp"
#include "brunt/core/simd.hpp"

namespace brunt::contact {
namespace {

/// Share of an impulse along the row's directions that the node is free to follow: with friction any direction counts.
/// length: of the row's normal.
double free_share(const Row& row, double length, const Mobility& mobility) {
  if (mobility.is_free()) return row.friction > 0 ? 1.0 : length;
  if (row.friction > 0) return mobility.projector.norm() > Mobility::rounding ? 1.0 : 0.0;
  const double along = (mobility.projector * row.normal).norm();
  return along > Mobility::rounding ? along : 0.0;
}

/// |G_qn P_n| of node i of a row (of a lever: a bound of it).
double weight_of(const Row& row, double length, std::size_t i, const Mobility& mobility) {
  const double weight = std::abs(row.weights[i]) + (row.lever == nullptr ? 0.0 : row.lever->size[i]);
  return weight * free_share(row, length, mobility);
}

/// Calls visit(node, |G_qn P_n|) for the nodes of a row.
template <class Visit>
void for_each_weight(const System& system, const Row& row, Visit&& visit) {
  const double length = row.normal.norm();
  for (std::size_t i = 0; i < static_cast<std::size_t>(row.node_count); ++i) {
    const auto node = static_cast<std::size_t>(row.nodes[i]);
    visit(node, weight_of(row, length, i, system.mobility[node]));
  }
}

/// Can an impulse in this row change its rate? Else the row is left out: prescribed motion has the authority. (Coulomb
/// friction needs a pressure: it is nothing where both sides are held along the normal.)
bool can_act(const System& system, const Row& row) {
  const double length = row.normal.norm();
  for (std::size_t i = 0; i < static_cast<std::size_t>(row.node_count); ++i) {
    const Mobility& mobility = system.mobility[static_cast<std::size_t>(row.nodes[i])];
    if (mobility.inverse_mass > 0 && weight_of(row, length, i, mobility) > 0 &&
        (std::isinf(row.friction) || mobility.is_free_along(row.normal)))
      return true;
  }
  return false;
}

/// binned_add of the three components at once.
class ImpulseGrid {
 public:
  explicit ImpulseGrid(const BinGrid& grid) : coarse_(Quad{} + grid.anchor[0]), fine_(Quad{} + grid.anchor[1]) {}
  void add(const Vec3& impulse, double* parts) const {
    const Quad term{impulse[0], impulse[1], impulse[2], 0};
    const Quad coarse = (term + coarse_) - coarse_, rest = term - coarse;
    add_to(parts, coarse);
    add_to(parts + 4, (rest + fine_) - fine_);
  }

 private:
  static void add_to(double* sum, const Quad& term) {
    Quad value;
    std::memcpy(&value, sum, sizeof value);
    value += term;
    std::memcpy(sum, &value, sizeof value);
  }
  Quad coarse_, fine_;
};

double shortfall(const Row& row, const Vec3& relative) {
  if (std::isinf(row.friction)) return missing_rate(row, relative).norm();
  const double missing = row.required - row.normal.dot(relative);
  return row.cone == Cone::compression ? std::max(missing, 0.0) : std::abs(missing);
}

/// Weights of this rank's rows, laid on their nodes; scratch.share keeps them.
void lay_weights(const System& system, EnforcementScratch& scratch, bool (*counts)(const Row&)) {
  constexpr double largest_weight = 4;  // of levers; others' are 1 at most
  const BinGrid grid = BinGrid::for_bound(largest_weight);
  scratch.row_sum_parts.assign(system.motion.size() * row_sum_width, 0.0);
  scratch.share.resize(system.rows.size());
  for (std::size_t q = 0; q < system.rows.size(); ++q) {
    scratch.share[q] = {};
    if ((counts != nullptr && !counts(system.rows[q])) || !can_act(system, system.rows[q])) continue;
    auto share = scratch.share[q].begin();
    for_each_weight(system, system.rows[q], [&](std::size_t node, double weight) {
      *share++ = weight;
      double* parts = &scratch.row_sum_parts[node * row_sum_width];
      binned_add(grid, weight, parts);
      parts[bin_slices] += 1;
    });
  }
}

/// From the parts, on owners.
void take_row_sums(EnforcementScratch& scratch) {
  scratch.row_sum.resize(scratch.row_sum_parts.size() / row_sum_width);
  for (std::size_t node = 0; node < scratch.row_sum.size(); ++node) {
    const double* parts = &scratch.row_sum_parts[node * row_sum_width];
    demand(parts[bin_slices] <= binned_terms, "more rows on one contact node than its sums can hold");
    scratch.row_sum[node] = binned_value(parts);
  }
}

/// From the row sums of all nodes; see form_row_sums.
bool lay_diagonal(const System& system, EnforcementScratch& scratch, bool (*counts)(const Row&)) {
  scratch.diagonal.assign(system.rows.size(), 0.0);
  bool coupled = false;
  for (std::size_t q = 0; q < system.rows.size(); ++q) {
    const Row& row = system.rows[q];
    if (counts != nullptr && !counts(row)) continue;
    coupled = coupled || row.lever != nullptr;  // its H is a bound
    for (std::size_t i = 0; i < static_cast<std::size_t>(row.node_count); ++i) {
      const auto node = static_cast<std::size_t>(row.nodes[i]);
      const Mobility& mobility = system.mobility[node];
      const double weight = scratch.share[q][i], sum = scratch.row_sum[node];
      if (mobility.inverse_mass > 0 && weight > 0)
        coupled = coupled || sum != weight || (row.friction > 0 && !mobility.projector.isIdentity(0));
      scratch.diagonal[q] += weight * sum * (system.mobility_scale * mobility.inverse_mass);
    }
  }
  return coupled;
}

/// Impulses of this rank's rows, laid on their nodes.
void lay_impulses(const System& system, std::span<const Vec3> impulses, double largest, EnforcementScratch& scratch) {
  const ImpulseGrid grid(BinGrid::for_bound(largest));
  scratch.impulse_parts.assign(system.motion.size() * impulse_width, 0.0);
  for (std::size_t q = 0; q < system.rows.size(); ++q) {
    if (impulses[q].isZero(0)) continue;
    const Row& row = system.rows[q];
    for (std::size_t i = 0; i < static_cast<std::size_t>(row.node_count); ++i)
      grid.add(impulse_on_node(row, i, impulses[q]),
               &scratch.impulse_parts[static_cast<std::size_t>(row.nodes[i]) * impulse_width]);
  }
}

Vec3 answer(const System& system, std::size_t node, const Vec3& impulse) {
  const Mobility& mobility = system.mobility[node];
  return system.mobility_scale * mobility.inverse_mass * (mobility.projector * impulse);
}

/// v = v* + W G^T p, on owners.
void take_velocities(const System& system, const EnforcementScratch& scratch, std::span<Vec3> velocity) {
  for (std::size_t node = 0; node < system.motion.size(); ++node)
    velocity[node] = system.motion[node].predicted + answer(system, node, impulse_of_node(scratch, node));
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

void EnforcementScratch::reserve(std::size_t rows, std::size_t nodes) {
  diagonal.reserve(rows);
  compliance.reserve(rows);
  share.reserve(rows);
  previous.reserve(rows);
  for (std::vector<Vec3>* of_rows : {&borne, &missing, &step, &direction, &step_change, &change})
    of_rows->reserve(rows);
  inverse.reserve(rows);
  chosen.reserve(rows);
  row_sum.reserve(nodes);
  row_sum_parts.reserve(nodes * row_sum_width);
  impulse_parts.reserve(nodes * impulse_width);
}

void EnforcementScratch::reserve_passes(std::size_t rows) {
  pass_rows.reserve(rows);
  pass_impulses.reserve(rows);
  for (std::vector<Vec3>& impulses : start) impulses.reserve(rows);
  asked.reserve(rows);
}

void demand_finite(double largest) {
  if (!std::isfinite(largest))
    throw GuardError("contact: an impulse is not finite; the velocities that came in are not, or grew without bound");
}

Vec3 relative_velocity(const Row& row, std::span<const Vec3> velocity) {
  return relative_motion(row, [&](LocalIndex node) -> const Vec3& { return velocity[static_cast<std::size_t>(node)]; });
}

double largest_impulse_on_a_node(std::span<const Row> rows, std::span<const Vec3> impulses) {
  double largest = 0;
  for (std::size_t q = 0; q < rows.size(); ++q) keep_max(largest, largest_share(rows[q]) * impulses[q].norm());
  return largest;
}

Vec3 missing_rate(const Row& row, const Vec3& relative) {
  const double along = row.normal.dot(relative);
  Vec3 missing = (row.required - along) * row.normal;
  if (row.friction > 0) missing += row.drift - (relative - along * row.normal);
  return missing;
}

double violation_here(const System& system, std::span<const Vec3> velocity) {
  double largest = 0;
  for (const Row& row : system.rows) {
    const double missing = shortfall(row, relative_velocity(row, velocity));
    if (missing != 0 && can_act(system, row)) keep_max(largest, missing);
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

bool form_row_sums(const System& system, Exchange& exchange, EnforcementScratch& scratch, bool (*counts)(const Row&)) {
  lay_weights(system, scratch, counts);
  exchange.sum_to_owner(scratch.row_sum_parts, row_sum_width);
  take_row_sums(scratch);
  exchange.share(scratch.row_sum, 1);
  return lay_diagonal(system, scratch, counts);
}

bool start_from_impulses(const System& system, std::span<const Vec3> impulses, double largest, Exchange& exchange,
                         std::span<Vec3> velocity, EnforcementScratch& scratch) {
  lay_weights(system, scratch, nullptr);
  lay_impulses(system, impulses, largest, scratch);
  exchange.sum_both_to_owner({scratch.row_sum_parts, row_sum_width}, {scratch.impulse_parts, impulse_width});
  take_row_sums(scratch);
  take_velocities(system, scratch, velocity);
  exchange.share_both({scratch.row_sum, 1}, as_values(velocity.first(system.motion.size())));
  return lay_diagonal(system, scratch, nullptr);
}

void form_diagonal(const System& system, EnforcementScratch& scratch) {
  scratch.diagonal.assign(system.rows.size(), 0.0);
  for (std::size_t q = 0; q < system.rows.size(); ++q) {
    for_each_weight(system, system.rows[q], [&](std::size_t node, double weight) {
      scratch.diagonal[q] += weight * weight * (system.mobility_scale * system.mobility[node].inverse_mass);
    });
  }
}

void apply_impulses(const System& system, std::span<const Vec3> impulses, double largest, Exchange& exchange,
                    std::span<Vec3> velocity, EnforcementScratch& scratch) {
  lay_impulses(system, impulses, largest, scratch);
  exchange.sum_to_owner(scratch.impulse_parts, impulse_width);
  take_velocities(system, scratch, velocity);
  share_velocities(exchange, velocity.first(system.motion.size()));
}

void velocities_of_impulses(const System& system, std::span<const Vec3> impulses, double largest, Exchange& exchange,
                            std::span<Vec3> velocity, EnforcementScratch& scratch) {
  lay_impulses(system, impulses, largest, scratch);
  exchange.sum_to_owner(scratch.impulse_parts, impulse_width);
  for (std::size_t node = 0; node < system.motion.size(); ++node)
    velocity[node] = answer(system, node, impulse_of_node(scratch, node));
  share_velocities(exchange, velocity.first(system.motion.size()));
}

}  // namespace brunt::contact
