// SPDX-License-Identifier: Apache-2.0
// Where no multiplier can act: ties whose two sides supports or walls drive apart, and contact whose two sides, or a
// wall and nodes, they drive into each other.
#pragma once
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "brunt/implicit/solver.hpp"

namespace brunt::implicit {

/// Motions across a tie agree where they differ by less than this share of a facet's edge: nodes that touch a wall at
/// the start lie within a tenth of it (`touching`), and walls then hold them in their planes.
constexpr double agreed = 1e-5;

/// The row of a tie that opens most.
struct DrivenApart {
  std::size_t interface = 0;
  GlobalIndex slave = -1, master = -1;  ///< canonical numbers: the row's node, and the nearest of the place under it
  Vec3 apart = Vec3::Zero();            ///< motion of the slave less that of the master's place [length]
  Vec3 place = Vec3::Zero();            ///< of the slave node at the start [length]
};

/// After a step that has converged: along directions without multipliers. The same on all ranks. Collective.
std::optional<DrivenApart> driven_apart(const comm::Communicator& ranks, const MortarContact& contact);

/// By supports alone at a time to come, where both sides' motions are given from t = 0 on; acceleration is not looked
/// at. The same on all ranks. Collective.
std::optional<DrivenApart> driven_apart_at(const comm::Communicator& ranks, const model::Model& model, double time,
                                           const MortarContact& contact);

/// Times at which a motion of supports changes its course, up to `end`, ascending, and `end`.
std::vector<double> turning_times(const model::Model& model, double end);

/// Looks for rows of contact and for nodes at walls that lie behind what cannot give way, since supports hold all their
/// nodes along the normal; deepens Solver::driven. Returns a warning for each that is new. Collective.
std::vector<std::string> watch_driven(const Scene& scene, Solver& solver, const std::string& length_unit);

/// Depth of all of them so far [length].
double driven_penetration(const Solver& solver);

}  // namespace brunt::implicit
