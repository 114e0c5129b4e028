// SPDX-License-Identifier: Apache-2.0
// The phase before t = 0: dynamic relaxation to a static state under the loads of t = 0, by kinetic damping (P. A.
// Cundall, "Explicit finite difference methods in geomechanics", 1976; M. R. Barnes, "Form-finding and analysis of
// prestressed nets and membranes", Computers & Structures 30 (1988) 685-695).
//
// The bodies move as in a run, but time remains 0: loads keep their values of t = 0, driven nodes and walls are at
// rest. A few steps after each peak of the kinetic energy, where an oscillation passes its equilibrium, all nodes are
// stopped. The remaining part of an oscillation is the share of its energy by which the peak was missed, so no damping
// coefficient is needed.
#pragma once
#include <span>

#include "model/model.hpp"
#include "time/links.hpp"
#include "time/step.hpp"

namespace brunt::time {

/// Loads are applied in this many equal stages, one more at each stop. A sudden load lets an elastic body oscillate to
/// twice its static deformation; a tenth of the load to 1/10 more, so plastic flow begins at most that much early.
constexpr int relaxation_stages = 10;

struct RelaxationSettings {
  double tolerance = 1e-4;  ///< of forces: unbalanced over applied; of energies its square: kinetic over strain energy
};

struct RelaxationStep {
  StepReport step;
  bool stopped = false;  ///< an oscillation has ended: the next step stops the nodes
  bool at_rest = false;  ///< the static state is found, the nodes have been stopped: the run may begin
};

/// One step of the phase. At rest: all stages are applied, the unbalanced forces (the norm of all nodal forces,
/// including contact, walls and supports) are below `tolerance` times the norm of the loads, and no oscillation within
/// the number of steps of the longest one had more kinetic energy than tolerance^2 times the stored energy. The error
/// of the static state in the energy norm is then about `tolerance`. `contact` as in `advance`. Collective.
RelaxationStep relax(const model::Model& model, model::State& state, model::Scratch& scratch, Links& links,
                     contact::Contact* contact, const StepControl& control, const RelaxationSettings& settings);

/// Ends the phase: initial velocities, t = 0, step 0, impulses from zero. The bodies keep displacements, stresses and
/// the work of their forces, which is counted as work of the loads, node by node: external = internal + hourglass +
/// bulk at t = 0. (The caller resets the work of contact.)
void begin_run(const model::Model& model, model::State& state, std::span<const Vec3> velocity,
               std::span<const Vec3> rate = {});

}  // namespace brunt::time
