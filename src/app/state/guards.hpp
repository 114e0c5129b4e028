// SPDX-License-Identifier: Apache-2.0
// The guards of a run: extremes of its ledgers so far, and the conclusions about errors of the energy. Pure functions
// of ledgers.
#pragma once
#include <string>
#include <vector>

#include "scene/guards.hpp"
#include "time/ledger.hpp"

namespace brunt::app {

/// Errors that a ledger may show.
enum class Fault {
  balance,    ///< the total has changed
  hourglass,  ///< a column that cannot be negative is so
  bulk,
  damping,
  friction,  ///< without the shear of ties, which friction holds too
  internal,  ///< of stresses: bodies cannot give more than they took
  contact,   ///< unless the scene lets it part bodies that began inside each other
  returned   ///< contact has given back energy that it had dissipated; see Gives
};
constexpr int guarded_columns = 8;

/// Extremes of the whole run since t = 0, the same on every rank. Doubles only: a checkpoint stores them with the
/// state.
struct Extremes {
  double first_dt = 0;          ///< the first step that the elements allowed [time]; 0 before it
  double begun = 0;             ///< 1 once a ledger was seen
  double start_total = 0;       ///< energy at t = 0
  double largest_energy = 0;    ///< largest of start_total, kinetic + internal, |external|: the scale of errors
  double largest_bodies = 0;    ///< largest of start_total, kinetic + internal
  double largest_internal = 0;  ///< [energy]
  double largest_contact = 0;   ///< largest energy dissipated by contact in whole steps; 0 at least
  double largest_stored = 0;    ///< largest part of it that compliant rows stored, and may return [energy]
  double largest_error = 0;     ///< largest |total - start_total| [energy]
  double start_momentum[3] = {0, 0, 0};     ///< less what was given [momentum]
  double momentum_error = 0;                ///< largest |p - p0 - impulses given| over the largest sum of m |v|
  double momentum_scale = 0;                ///< largest sum of m |v|, and |p0| [momentum]
  double worst[guarded_columns] = {};       ///< of runs that are judged at their end: largest of each fault [energy]
  double worst_time[guarded_columns] = {};  ///< when it was
};
constexpr int worst_width = 2 * guarded_columns;  ///< its last members
constexpr int extremes_width = sizeof(Extremes) / sizeof(double) - worst_width;

/// Change of the total since the start, divided by the largest energy so far; 0 while there was none.
double energy_change(const time::Ledger& ledger, const Extremes& seen);

/// Largest change of the total divided by the largest energy, both over the run so far. A ratio of each single step
/// would divide rounding errors by zero energy in the first steps of a run from rest.
double error_ratio(const Extremes& seen);

/// Takes a ledger into account.
void observe(const time::Ledger& ledger, Extremes& seen);

/// Energies below this are rounding [energy]. A position is rounded to about 1e-16 of its distance from the model's
/// origin, and so moves by up to 4 eps `extent` in a step without a cause. Where bodies touch, contact responds with up
/// to 1e-12 of an edge (measured on bodies at rest). The result is twice the kinetic energy of the whole mass at the
/// speed of one such motion in one step: it follows units, size and step.
double rounding_energy(double mass, double extent, double edge, double dt);

/// Energy exchanged by bodies at rest due to the tolerance of contact [energy]. A step leaves a residual of tolerance g
/// dt of the velocity due to weight, and recovery takes back such a small share of a penetration in each step that it
/// settles at tolerance g dt^2 / recovery: the result is the weight times this depth. Deformable bodies store more
/// energy by their weight; rigid bodies at rest have no other energy for comparison.
double settling_energy(double mass, double gravity, double dt, double tolerance, double recovery);

/// Kinetic energy without a source, which a closed ledger does not show. recovered: contact may supply energy, since
/// the scene lets it separate initially overlapping bodies. Empty, or the message; among_rigid: where the
/// energy may come from in a scene without deformable elements (cause_among_rigid_bodies), instead of these and of a
/// stable step.
std::string energy_growth(const time::Ledger& ledger, const Extremes& seen, bool recovered, double rounding,
                          const std::string& among_rigid = {}, const scene::Guards& limits = {});

/// What contact may give without an error: nothing, what its springs have stored, or the work that parts bodies which
/// began inside each other.
enum class Gives { nothing, stored, parting };

struct Finding {
  Fault fault = Fault::balance;
  double energy = 0;  ///< the change of the total; else the column [energy]
  double share = 0;   ///< |energy| over the largest energy, so far or of the run
  bool stop = false;
};

/// Findings above limits.energy_warning, in the order of Fault. rounding: see rounding_energy; shares refer to at least
/// ten times this value, so that rounding stays below the warning.
std::vector<Finding> judge(const time::Ledger& ledger, const Extremes& seen, double rounding,
                           Gives gives = Gives::nothing, const scene::Guards& limits = {});

/// Takes the faults of a ledger into account that are judged at the end of the run: Extremes::worst. A static run from
/// rest has next to no energy when bodies first touch, so an error that is nothing at the end is a large share there;
/// and an error does not grow by itself, since each state is one of equilibrium. The balance is judged at once.
void note_worst(const time::Ledger& ledger, Gives gives, double time, Extremes& seen);

/// Findings among these at the end, as shares of the largest energy of the whole run.
std::vector<Finding> judge_whole(const Extremes& seen, double rounding, const scene::Guards& limits = {});

/// The sentence for it, without the place: what is wrong. of: what the share is of.
std::string text_of(const Finding& finding, double time, const char* of = "the largest energy so far");
/// What to do about it, or where it comes from. Empty for `internal`, see cause_of_given_work. among_rigid: see
/// energy_growth.
std::string likely_cause(Fault fault, const std::string& among_rigid = {});

/// Share of the largest energy of the bodies that contact has taken, if bodies have touched and none touches another
/// one any more; otherwise 0. For two elastic bodies it should be zero.
double taken_by_parted(const time::Ledger& ledger, const Extremes& seen);

/// Angular momentum that contact between bodies has supplied, over `extent` (half the diagonal of the model [length])
/// and the larger one of the largest momentum and of the sum of all impulses of contact: the mean offset between the
/// two points of an impulse in units of the extent.
double angular_error(const time::Ledger& ledger, const Extremes& seen, double extent);

}  // namespace brunt::app
