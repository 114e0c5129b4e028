// SPDX-License-Identifier: Apache-2.0
// `--set key.path=value`: changes to a scene's tree before it is read.
#pragma once
#include <span>
#include <string>

#include "brunt/scene/tree.hpp"

namespace brunt::scene {

/// Applies the overrides in order. Paths go through maps by key and through lists by index from 0; a missing key is
/// made (whether it is known is the reader's matter); the value is YAML; `null` takes the key away.
void apply_overrides(Tree& scene, std::span<const std::string> overrides, Faults& faults);

}  // namespace brunt::scene
