// SPDX-License-Identifier: Apache-2.0
// The rotations of nodes of shells in a step. Moments at t_n change the rates of rotation as forces change velocities,
//   r_{n+1/2} = r_{n-1/2} + dt_mean (M - internal)/J,   turn_{n+1} = cay(dt r_{n+1/2}) turn_n,
// cay(c) = (1 - [c/2])^-1 (1 + [c/2]): the rotation whose chords at the midpoint are c x. J is the same about all axes,
// so a free node keeps its rate. Mass damping acts on rates as on velocities (time/motion.hpp). Contact has no moments.
#pragma once
#include <span>
#include <vector>

#include "model/model.hpp"
#include "model/registry.hpp"
#include "time/links.hpp"
#include "time/motion.hpp"

namespace brunt::time {

/// Sizes all arrays of rotations; nothing turns yet.
void size_rotations(const model::Model& model, model::State& state, model::Scratch& scratch);

/// Inertia of the nodes and Model::turning. The histories of the elements have their masses. Collective.
void weigh_rotations(model::Model& model, model::State& state, model::Scratch& scratch, Links& links);

/// Rates at the start, `rate` by node (none: zero), with supports and drives.
void start_rotations(const model::Model& model, model::State& state, std::span<const Vec3> rate);

/// From t_n to t_{n+1}, with the accounts of all moments.
void advance_rotations(const model::Model& model, model::State& state, model::Scratch& scratch, const Interval& step);

/// Energies of the rotation of a node, with half of the work of the last moments subtracted as for velocities
/// (time/ledger.cpp).
struct RotationEnergies {
  double kinetic = 0, element_work = 0, load_work = 0, damping_work = 0, reaction_work = 0;
};
RotationEnergies rotation_energies(const model::State& state, const model::Scratch& scratch, const Interval& step,
                                   LocalIndex node);

// For the phase before t = 0 (time/relaxation).

/// Squares of the unbalanced moment on a node after a step of `dt_mean`, supports included, and of the moment of loads.
/// Both as forces on the radius of gyration of the node, sqrt(J/m), as in the energy of its motion.
struct RotationBalance {
  double left = 0, given = 0;  ///< [force^2]
};
RotationBalance balance_of_rotation(const model::State& state, const model::Scratch& scratch, double dt_mean,
                                    LocalIndex node);

double kinetic_energy_of_rotation(const model::State& state, LocalIndex node);

/// Brings rotations to rest at t_n: half a step before, their rates are minus those that the moments produce until
/// then.
void stop_rotations(const model::Model& model, const model::Scratch& scratch, double dt_mean, model::State& state);

/// The work of elements up to now was that of the loads; all other accounts begin.
void begin_accounts_of_rotations(const model::Model& model, model::State& state);

/// To the arrays of the state; `nodes`: all local ones.
void add_rotations(model::State& state, LocalIndex nodes, std::vector<model::StateArray>& arrays);

}  // namespace brunt::time
