// SPDX-License-Identifier: Apache-2.0
// How contact is enforced, for all contact of a scene and for rigid walls: the section `enforcement`, and the same keys
// in entries of `contact`. A key that is given in several entries has the value of the last one.
#pragma once
#include <vector>

#include "scene/input.hpp"
#include "scene/keys/table.hpp"

namespace brunt::scene {

/// Names of the methods in a scene.
const Choices<contact::Method>& methods();

/// Rows of the section, which those of an entry of `contact` repeat.
const std::vector<Row<Enforcement>>& enforcement_rows();

/// Judges the settings of an entry of `contact` beside those of the section, which an entry may repeat, but not change.
/// given: the settings after the entry; input has those before it.
void judge_enforcement_of_entry(const Key& entry, const Enforcement& given, const Input& input);

/// Judges the section beside contact and walls, when all have been read.
void judge_enforcement(const Key& scene, const Input& input);

}  // namespace brunt::scene
