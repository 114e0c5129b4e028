// SPDX-License-Identifier: Apache-2.0
// `--set key.path=value`: changes of the scene's tree before it is read.
#pragma once
#include <span>
#include <string>

#include "scene/text/tree.hpp"

namespace brunt::scene {

/// Applies the overrides in order. Paths follow maps by key and lists by index from 0. A missing key is created (the
/// reader decides whether it is known). The value is YAML; `null` removes the key.
void apply_overrides(Tree& scene, std::span<const std::string> overrides, Faults& faults);

}  // namespace brunt::scene
