// SPDX-License-Identifier: Apache-2.0
// Rules about several sections of a scene, and about the plausibility of values. What one section may be is judged
// beside the table of its keys, and what depends on the mesh when the model is built.
#pragma once
#include <string>
#include <vector>

#include "scene/input.hpp"
#include "scene/text/reader.hpp"

namespace brunt::scene {

// While a scene is read: faults and warnings are reported with all others.

/// Names that are used but not defined, generated parts without an entry in `parts`, names that are used twice.
void judge_names(const Key& scene, const Input& input);

/// Warns of a density or wave speed outside those of known matter, where the scene names its units.
void warn_of_units(const Key& material, const material::Law& law, const std::string& unit_system);

// Of an Input without faults, whatever it was read from. Each gives lines "FILE:LINE: key: what is wrong; expected
// ...".

/// Rotations of nodes, mass properties of a part that is not rigid, parts that join others, a missing step where no
/// element limits it.
[[nodiscard]] std::vector<std::string> faults_of_rigid_parts(const Input& input);

/// Joints of parts that are not rigid or that are one body, and scenes that have no joints in this version.
[[nodiscard]] std::vector<std::string> faults_of_joints(const Input& input);

/// Laws, contact, solvers and criteria of erosion that parts of shells do not have, moments without shells.
[[nodiscard]] std::vector<std::string> faults_of_shells(const Input& input);

/// What implicit scenes may not have, and explicit ones of implicit scenes.
[[nodiscard]] std::vector<std::string> faults_of_solver(const Input& input);

}  // namespace brunt::scene
