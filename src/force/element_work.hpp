// SPDX-License-Identifier: Apache-2.0
// The work of the forces of single elements, for elements that may be removed (Scratch::element_force). The work that
// the ledger sums by node is then also known by element, up to rounding. For blocks that may lose elements it costs a
// second gather of velocities and 24 doubles for each element, written and read again (12 for tetrahedra); other blocks
// have no cost.
#pragma once
#include "model/model.hpp"

namespace brunt::force {

/// After the step from t_n: adds the work of the forces of each element to State::element_work, each impulse times the
/// mean of the velocities before and after. The forces of elements removed at t_n act a last time.
void book_element_work(const model::Model& model, model::State& state, model::Scratch& scratch, double dt_mean);

/// Adds to State::element_work the work of the forces on nodes that move with their present velocities for a given
/// time.
void add_element_work(const model::Model& model, model::State& state, const model::Scratch& scratch, double time);

}  // namespace brunt::force
