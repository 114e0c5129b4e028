// SPDX-License-Identifier: Apache-2.0
// Costs of the elements of a scene, for the partition.
#pragma once
#include "element/options.hpp"
#include "mesh/canonical.hpp"
#include "partition/split.hpp"
#include "scene/input.hpp"

namespace brunt::app {

/// Time of an element relative to the one-point hexahedron. points: through the thickness of a shell.
double cost_of(element::ElementKind kind, int points, bool rigid);

/// Costs of the elements and their faces that will bring contact its work (none without contact between parts: rows
/// of walls cost little). whole: with the selections of the scene.
partition::Weights weigh(const scene::Input& input, const mesh::CanonicalMesh& whole);

}  // namespace brunt::app
