// SPDX-License-Identifier: Apache-2.0
// Faults of implicit scenes: each is a line with its place and the expected values.
#pragma once
#include <string>
#include <vector>

#include "app/state/guards.hpp"
#include "model/model.hpp"
#include "scene/input.hpp"

namespace brunt::app {

/// Elements, laws and pairs that implicit steps cannot have; what needs no mesh is judged when the scene is read
/// (scene/rules). The same on all ranks.
std::vector<std::string> faults_of_implicit(const scene::Input& input, const model::Model& model);

/// Notes on the treatment of overlaps with initial_overlap: warn, a line for each entry that has it.
std::vector<std::string> notes_of_overlaps(const scene::Input& input);

/// Likely cause of an error of the energies in an implicit run.
std::string likely_cause_in_implicit(Fault fault, const model::Model& model,
                                     model::Scheme scheme = model::Scheme::contact_implicit);

/// Valid settings that perform poorly.
std::vector<std::string> warnings_of_implicit(const scene::Input& input, const model::Model& model);

}  // namespace brunt::app
