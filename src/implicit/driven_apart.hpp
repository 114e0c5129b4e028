// SPDX-License-Identifier: Apache-2.0
// Constraints that no multiplier can satisfy: ties whose two sides are separated by supports or walls, and contact
// whose two sides, or a wall and nodes, are driven into each other.
#pragma once
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "implicit/solver.hpp"

namespace brunt::implicit {

/// Motions across a tie are compatible if they differ by less than this share of a facet's edge: nodes that touch a
/// wall in the initial configuration lie within a tenth of it (`touching`), and walls then constrain them to their
/// planes.
constexpr double agreed = 1e-5;

/// The row of a tie with the largest opening.
struct DrivenApart {
  std::size_t interface = 0;
  GlobalIndex slave = -1, master = -1;  ///< canonical numbers: the row's node, its master node of largest weight
  Vec3 apart = Vec3::Zero();            ///< motion of the slave minus that of its projection [length]
  Vec3 place = Vec3::Zero();            ///< of the slave node at the start [length]
};

/// After a converged step: along directions without multipliers. The same on all ranks. Collective.
std::optional<DrivenApart> driven_apart(const comm::Communicator& ranks, const MortarContact& contact);

/// By supports only, at a future time, if the motions of both sides are prescribed from t = 0 on; prescribed
/// accelerations are not considered. The same on all ranks. Collective.
std::optional<DrivenApart> driven_apart_at(const comm::Communicator& ranks, const model::Model& model, double time,
                                           const MortarContact& contact);

/// Times up to `end` at which a prescribed motion changes its slope, ascending, and `end`.
std::vector<double> turning_times(const model::Model& model, double end);

/// Two parts, or a part and a wall, that supports move through each other.
struct DrivenThrough {
  std::int32_t block = 0, other = 0;  ///< other: a block, or -1 - w for wall w
  double since = 0, depth = 0;        ///< [time], [length]
};

/// Searches rows of contact and nodes at walls whose penetration cannot be resolved, since supports constrain all their
/// nodes along the normal; updates Solver::driven. Returns those that are new. Collective.
std::vector<DrivenThrough> watch_driven(const Scene& scene, Solver& solver);

/// Whether the node, of a rigid body, can move along the normal of a wall near it.
bool yields_to_walls(const model::Model& model, const Solver& solver, const WallNode& node);

/// Largest penetration of all of them so far [length].
double driven_penetration(const Solver& solver);

}  // namespace brunt::implicit
