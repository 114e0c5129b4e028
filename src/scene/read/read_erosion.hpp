// SPDX-License-Identifier: Apache-2.0
// The map `erosion` of a part.
#pragma once
#include <map>
#include <string>

#include "scene/input.hpp"
#include "scene/keys/table.hpp"

namespace brunt::scene {

extern const Table<model::Erosion> erosion_keys;

/// Judges whether the material of a part has the quantities that its criteria need. map: the map `erosion`.
void judge_erosion_of_part(const Key& map, const Part& part, const std::map<std::string, material::Law>& materials);

}  // namespace brunt::scene
