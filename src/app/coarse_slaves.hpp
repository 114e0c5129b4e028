// SPDX-License-Identifier: Apache-2.0
// Pairs of which the scene names the coarser side as the slave.
#pragma once
#include <string>
#include <vector>

#include "brunt/mesh/canonical.hpp"
#include "brunt/scene/input.hpp"

namespace brunt::app {

/// A line for each pair that meets in one pass and whose named slave has faces with edges more than twice as long as
/// the master's (medians of the longest edges, of the faces that are near the other part or fly towards it): in between
/// the slave's nodes nothing holds the master's, and no figure shows how deep they are. whole: with the selections of
/// the scene.
std::vector<std::string> warn_of_coarse_slaves(const scene::Input& input, const mesh::CanonicalMesh& whole);

}  // namespace brunt::app
