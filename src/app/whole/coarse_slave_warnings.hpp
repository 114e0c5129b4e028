// SPDX-License-Identifier: Apache-2.0
// Warnings about pairs for which the scene names the coarser side as the slave.
#pragma once
#include <string>
#include <vector>

#include "mesh/canonical.hpp"
#include "scene/input.hpp"

namespace brunt::app {

/// A line for each (see setup/coarse_slaves.hpp). whole: with the selections of the scene.
std::vector<std::string> warn_of_coarse_slaves(const scene::Input& input, const mesh::CanonicalMesh& whole);

}  // namespace brunt::app
