// SPDX-License-Identifier: Apache-2.0
// The work of the forces of single elements, where elements may be removed (Scratch::element_force): what the ledger
// books by node is known by element too, to rounding. It costs blocks that may lose elements a second gather of
// velocities and 24 doubles an element written and read again (12 of tetrahedra); others nothing.
#pragma once
#include "brunt/model/model.hpp"

namespace brunt::force {

/// After the step from t_n: adds to State::element_work what the forces of each element did, each impulse times the
/// mean of the velocities before and after. Those of elements removed at t_n act a last time.
void book_element_work(const model::Model& model, model::State& state, model::Scratch& scratch, double dt_mean);

/// Adds to State::element_work what the forces do on nodes that move for some time with the velocities that they have.
void add_element_work(const model::Model& model, model::State& state, const model::Scratch& scratch, double time);

}  // namespace brunt::force
