// SPDX-License-Identifier: Apache-2.0
// Removal of elements by the scene, and the data of the run that depend on their flags.
#pragma once
#include "app/program/log.hpp"
#include "prepared.hpp"

namespace brunt::app {

/// Between evaluate and advance: removes the elements that are due, and reports it. Collective.
void remove_due(Prepared& run, Log& log);

/// The elements eroded since this program started, by part and criterion.
void report_erosion(const Prepared& run, Log& log);

/// Updates the surface of the remaining bodies in contact. Collective.
void expose(const scene::Input& input, const model::Model& model, const model::State& state, const time::Links& links,
            contact::Contact& contact);

/// Updates the data that depend on the flags of the state, after a restart. Collective.
void follow_alive(Prepared& run);

/// Throws InputError if all elements that could determine the first step meet a criterion of erosion, and the scene
/// gives no step. The state is that of t = 0. Collective.
void demand_first_step(Prepared& run);

}  // namespace brunt::app
