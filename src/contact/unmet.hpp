// SPDX-License-Identifier: Apache-2.0
// Rows that no motion can satisfy: a rigid body between a fixed and a driven one, a driven one in front of a wall, a
// chain of such bodies without a way out.
//
// G v >= required has no solution if and only if some impulses d >= 0 of its rows move nothing, W G^T d = 0, and do
// work on the required rates, d . (required - G v*) > 0 (Farkas' lemma). The iteration finds them: with the memory of
// impulses from step to step it is a proximal point iteration, and what its impulses grow by in a step converges to d
// where there is no solution, and to zero where there is one (Banjac, Goulart, Stellato and Boyd, J. Optim. Theory
// Appl. 183, 2019, use the same difference). A row is therefore unmet if its impulse has grown in the step, and if in
// its island, the rigid bodies joined by such rows, this growth moves no body, and the mean of the rates that are still
// missing, weighted by it, is no remainder. A single row of a chain may miss little: its compliance times its growth.
// Deformable bodies can yield, so rows on their free nodes belong to no island.
//
// Of unmet rows the impulses that are remembered stay as they were, otherwise they would grow with time and be released
// as motion as soon as one of the rows opens. Their penetration is not recovered, and the work that they take is
// booked by itself.
#pragma once
#include <cstdint>
#include <vector>

#include "contact/enforcement/enforce.hpp"
#include "contact/node_views.hpp"

namespace brunt::contact {

struct Contact;

/// Numbers that decide, dimensionless.
struct UnmetNumbers {
  /// Impulses move a body by nothing if what they add up to is less than this share of their sum, in the norm of the
  /// body's mobility: softness leaves 0.05 / 2 of the velocity lost in a step.
  double balanced = 0.02;
  /// Multiples of the tolerance of the iteration: a mean of missing rates beyond it is no remainder of the iteration.
  double remainder = 10;
  /// Residual of an iteration that ended at its limit from which on it is repeated by sweeps alone: half of the
  /// violation is left, or more than there was.
  double astray = 0.5;
  /// Share of a rigid body that driven penetration may reach.
  double share_of_body = 0.01;
  /// Share of the depth in which contact sees a node behind a face: beyond it the body would be lost.
  double share_of_sight = 0.5;
};
constexpr UnmetNumbers unmet_numbers;

/// Of the last step; sized where lists are rebuilt.
struct Unmet {
  std::vector<Vec3> start;  ///< impulses that the iteration began with [momentum], a row each
  std::vector<char> rows;   ///< a flag each: it is unmet; empty: no row of any rank is
  bool any = false;         ///< some row of some rank is
  std::vector<char> held;   ///< a flag each: it was unmet in an earlier step and has been closed since
  std::vector<Row> jammed;  ///< taken out of the step: turning cannot satisfy them, see jams.hpp
  double excess = 0;        ///< largest driven penetration of rigid bodies over what is admitted, of all ranks

  std::vector<Vec3> growth;           ///< of impulses of rows [momentum], zero of those that do not grow
  std::vector<double> gain;           ///< growth along the normal times the missing rate [energy], a row each
  std::vector<std::int64_t> sums;     ///< of bodies
  std::vector<double> island, other;  ///< of bodies: minus the lowest number of its island
  std::vector<char> balanced;         ///< of islands, by that number

  void reserve(std::size_t most_rows, std::size_t bodies);
  [[nodiscard]] bool is(std::size_t row) const { return !rows.empty() && rows[row] != 0; }
};

/// Rows that were unmet and are closed require no recovery. Called before anything follows from the required rates.
void hold_unmet_rows(Contact& contact, const StepInput& input);

/// A system of a step, and what enforcement has made of it.
struct Solved {
  const System& system;
  const EnforcementScratch& scratch;
  std::span<const Vec3> impulses;  ///< of rows [momentum]
  std::span<const Vec3> velocity;  ///< of contact nodes
};

/// Finds the unmet rows after enforcement that began with unmet.start. least: islands whose rows miss less in the mean
/// are met [velocity]. Collective.
void find_unmet_rows(const Solved& solved, double least, Exchange& exchange, Unmet& unmet);

/// The impulses to remember, in unmet.start; unmet.held then contains the rows to remember as unmet.
void keep_met_impulses(Contact& contact);

}  // namespace brunt::contact
