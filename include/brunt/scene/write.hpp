// SPDX-License-Identifier: Apache-2.0
// A scene's tree as YAML again: the record of what a run has read, overrides included.
#pragma once
#include <span>
#include <string>

#include "brunt/scene/tree.hpp"

namespace brunt::scene {

/// YAML that parses to the same tree. What fits a line stands in one, between brackets; comments of the source are
/// lost.
[[nodiscard]] std::string as_yaml(const Tree& tree);

/// The scene of a text after its overrides, as YAML. Empty for a faulty scene.
[[nodiscard]] std::string as_yaml(const std::string& text, const std::string& file_name,
                                  std::span<const std::string> overrides);

}  // namespace brunt::scene
