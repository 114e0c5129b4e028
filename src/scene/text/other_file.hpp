// SPDX-License-Identifier: Apache-2.0
// Files that are given as a scene by mistake.
#pragma once
#include <string>
#include <string_view>

namespace brunt::scene {

/// The fault of a file that is a mesh, a deck or a surface by its first line and its extension, with what to do; empty
/// if it may be a scene. None of these first lines begins a scene in YAML.
[[nodiscard]] std::string fault_of_other_file(std::string_view text, const std::string& file);

}  // namespace brunt::scene
