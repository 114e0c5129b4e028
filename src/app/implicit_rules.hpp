// SPDX-License-Identifier: Apache-2.0
// What an implicit scene may not ask for: each a line with its place and what is accepted.
#pragma once
#include <string>
#include <vector>

#include "brunt/model/model.hpp"
#include "brunt/scene/input.hpp"
#include "guards.hpp"

namespace brunt::app {

/// What explicit scenes may not ask for of implicit ones, too. The same on all ranks.
std::vector<std::string> faults_of_implicit(const scene::Input& input, const model::Model& model);

/// What becomes of overlaps with initial_overlap: warn, a line for each entry that has it.
std::vector<std::string> notes_of_overlaps(const scene::Input& input);

/// Likely cause of what is wrong with the energies of an implicit run.
std::string likely_cause_in_implicit(Fault fault);

/// What works, but not as well as it could.
std::vector<std::string> warnings_of_implicit(const scene::Input& input, const model::Model& model);

}  // namespace brunt::app
