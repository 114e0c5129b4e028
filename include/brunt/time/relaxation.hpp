// SPDX-License-Identifier: Apache-2.0
// The phase before t = 0: dynamic relaxation to a static state under the loads of t = 0, by kinetic damping (P. A.
// Cundall, "Explicit finite difference methods in geomechanics", 1976; M. R. Barnes, "Form-finding and analysis of
// prestressed nets and membranes", Computers & Structures 30 (1988) 685-695).
//
// The bodies move as in a run, but for time, which stands at 0: loads keep their values of t = 0, driven nodes and
// walls stand still. Some steps after each peak of the kinetic energy - a swing is through its equilibrium - all nodes
// are stopped. What is left of the swing is the share of its energy that the peak missed, so no damping has to be
// chosen.
#pragma once
#include <span>

#include "brunt/model/model.hpp"
#include "brunt/time/links.hpp"
#include "brunt/time/step.hpp"

namespace brunt::time {

/// Loads come in this many equal stages, a stage more at each stop: a load that comes at once lets an elastic body
/// swing to twice its static deformation, a tenth of it to 1/10 more, so that plastic flow begins at most that much
/// early.
constexpr int relaxation_stages = 10;

struct RelaxationSettings {
  double tolerance =
      1e-4;  ///< of forces: unbalanced over loads; of energies its square: a swing's over the strain energy
};

struct RelaxationStep {
  StepReport step;
  bool stopped = false;  ///< a swing is over: the next step stops the nodes
  bool at_rest = false;  ///< the static state is found, the nodes have been stopped: the run may begin
};

/// One step of the phase. At rest: all stages are through, the unbalanced forces (the norm of all nodes' forces,
/// contact, walls and supports among them) are below `tolerance` times the norm of the loads, and no swing within the
/// longest one's number of steps had more kinetic energy than tolerance^2 times the energy stored: the error of the
/// static state in the energy norm is about `tolerance`. `contact` as in `advance`. Collective.
RelaxationStep relax(const model::Model& model, model::State& state, model::Scratch& scratch, Links& links,
                     contact::Contact* contact, const StepControl& control, const RelaxationSettings& settings);

/// Ends the phase: initial velocities, t = 0, step 0, impulses from zero. The bodies keep displacements, stresses and
/// what their forces have done, which is booked as given by the loads, node by node: external = internal + hourglass +
/// bulk at t = 0. (What contact has taken is the caller's to clear.)
void begin_run(const model::Model& model, model::State& state, std::span<const Vec3> velocity);

}  // namespace brunt::time
