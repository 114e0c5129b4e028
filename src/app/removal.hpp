// SPDX-License-Identifier: Apache-2.0
// Elements that the scene removes, and what of the run follows their flags.
#pragma once
#include "log.hpp"
#include "prepare.hpp"

namespace brunt::app {

/// Between evaluate and advance: takes out the elements whose time has come, and tells of it. Collective.
void remove_due(Prepared& run, Log& log);

/// The elements eroded since this program began, by part and criterion.
void report_erosion(const Prepared& run, Log& log);

/// Gives contact the surface of what is left of the bodies. Collective.
void expose(const scene::Input& input, const model::Model& model, const model::State& state, const time::Links& links,
            contact::Contact& contact);

/// What follows from the flags of the state, as a restart has filled them. Collective.
void follow_alive(Prepared& run);

/// An InputError where all elements that could give a first step meet a criterion of erosion, and the scene gives none.
/// The state is that of t = 0. Collective.
void demand_first_step(Prepared& run);

}  // namespace brunt::app
