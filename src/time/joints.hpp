// SPDX-License-Identifier: Apache-2.0
// Joints of rigid bodies in a step. Their impulses act at x_n along G(x_n)^T and close the gaps at x_{n+1}:
//   g(x_{n+1}) = 0,  x_{n+1} from v_{n+1/2} = v* + W G(x_n)^T q,
// the method of Ryckaert, Ciccotti and Berendsen (SHAKE, J. Comput. Phys. 23, 1977, 327-341), by Newton's method with
// the matrix G W G^T of x_n: of second order and symmetric in time, and gaps do not add up. A first solution without
// contact comes before it; contact answers with what the joints let through (contact::CoupledBodies); a second one
// closes what the turn by contact has opened. Joints do no work: the discrete one, of second order, is not booked, and
// the energy error contains it.
#pragma once
#include <span>
#include <vector>

#include "contact/data/carriers.hpp"
#include "contact/enforcement/carried.hpp"
#include "model/model.hpp"
#include "time/motion.hpp"

namespace brunt::time {

/// Arms, sizes and groups of the joints, when the bodies have been weighed.
void place_joints(model::Model& model, model::State& state, model::Scratch& scratch);

/// Closes the joints for the predicted velocities. Throws GuardError if a joint stays open.
void hold_joints(const model::Model& model, const model::State& state, const Interval& step, model::Scratch& scratch);

/// Answers of bodies with joints, and the blocks of the bodies themselves in `carriers`.
void couple_carriers(const model::Model& model, const model::Scratch& scratch, std::vector<contact::Carrier>& carriers,
                     std::vector<contact::CoupledBodies>& coupled);

/// Adds the effect of contact on bodies with joints, and closes these again.
void push_jointed(const model::Model& model, const model::State& state, std::span<const contact::BodyAnswer> answers,
                  const Interval& step, model::Scratch& scratch);

/// After contact: the accounts of joints, and reactions of supports of points.
void book_joints(const model::Model& model, model::State& state, model::Scratch& scratch);

}  // namespace brunt::time
