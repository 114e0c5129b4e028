// SPDX-License-Identifier: Apache-2.0
// Accounts of contact: work and impulses of a run, and solver statistics.
#pragma once
#include <array>
#include <vector>

#include "comm/exact_sum.hpp"
#include "contact/enforcement/enforce.hpp"

namespace brunt::contact {

/// Energy taken from the bodies [energy].
struct WorkSums {
  comm::ExactAccumulator contact;   ///< by contact between them, along the normals
  comm::ExactAccumulator friction;  ///< across the normals, on walls too
  comm::ExactAccumulator walls;     ///< by walls, along their normals
  comm::ExactAccumulator ties;      ///< the part of `friction` due to ties, which may be returned
  comm::ExactAccumulator driven;    ///< by rows that cannot be satisfied, along their normals
};

/// Sums of one tracked contact, acting on its block. For self-contact of a block the impulses on both sides cancel, and
/// only the sums of magnitudes are meaningful.
struct TrackedSums {
  std::array<comm::ExactAccumulator, 3> impulse;   ///< [momentum]
  std::array<comm::ExactAccumulator, 3> friction;  ///< of it, across the normals of the rows
  comm::ExactAccumulator normal_size;              ///< sum of the sizes of the parts along the normals [momentum]
  comm::ExactAccumulator friction_size;            ///< and of those across them
};

/// Exact sums over the run on this rank; they are reduced over the ranks only on request (see `collect`).
struct ContactSums {
  WorkSums work;
  std::vector<std::array<comm::ExactAccumulator, 3>> wall_impulse;  ///< by each wall on the bodies [momentum]
  std::vector<TrackedSums> tracked;                                 ///< of each of ContactSettings::tracked
  /// Angular momentum supplied by contact between bodies: zero if the points of application of each pair of impulses
  /// coincide, or if the impulse acts along the line between them.
  std::array<comm::ExactAccumulator, 3> spin;
  comm::ExactAccumulator push;  ///< magnitudes of the impulses between bodies [momentum]
  double penetration = 0;       ///< largest so far [length]
};

/// TrackedSums after reduction over all ranks.
struct TrackedTotals {
  Vec3 impulse = Vec3::Zero(), friction = Vec3::Zero();
  double normal_size = 0, friction_size = 0;
};

/// The same after reduction over all ranks.
struct ContactTotals {
  double contact_work = 0, friction_work = 0, wall_work = 0, tie_work = 0;  ///< that of ties is in friction_work too
  double driven_work = 0;  ///< of rows that cannot be satisfied, along their normals; in no other sum
  std::vector<Vec3> wall_impulse;
  std::vector<TrackedTotals> tracked;
  Vec3 spin = Vec3::Zero();  ///< given by contact between bodies [angular momentum]
  double push = 0;           ///< sum of the sizes of the impulses between bodies [momentum]
  double stored = 0;         ///< part of contact_work that compliant rows store after the last step and return [energy]
  GlobalIndex pairs = 0, active = 0;  ///< candidate pairs now; rows with an impulse in the last step
  GlobalIndex touching = 0;           ///< of these, rows between bodies, without ties
  double penetration = 0;             ///< largest of the run [length]
};

struct ContactStatistics {  ///< the same on every rank
  GlobalIndex steps = 0, searches = 0, solved_steps = 0, iterations = 0;
  GlobalIndex idle_steps = 0;  ///< without any near candidate
  int most_iterations = 0;
  double largest_residual = 0;
  GlobalIndex steps_at_limit = 0;  ///< that ended at max_iterations, with a residual above the tolerance
  GlobalIndex scaled_steps = 0;    ///< of these, steps that would have gained energy: see enforcement/energy_guard.hpp
  double least_share = 1;          ///< of the impulses that an island kept in them
  EnforcementResult last;
};

struct ContactLedger {
  ContactSums sums;
  ContactStatistics statistics;
  double clock = 0;  ///< sum of the steps since contact was made [time]
};

/// A row with friction.
struct RubbingRow {
  double work = 0;                       ///< taken by friction in the last step; < 0: given [energy]
  GlobalIndex slave_gid = no_index;      ///< no_index: there is none
  Vec3 position = Vec3::Zero();          ///< of the slave, less the mesh's origin
  std::int32_t master_block = no_index;  ///< no_index for a wall
};

}  // namespace brunt::contact
