// SPDX-License-Identifier: Apache-2.0
// From the text of a scene file to a typed Input. Every key, with type, unit, default and range: src/scene/README.md.
#pragma once
#include <span>
#include <string>

#include "scene/input.hpp"

namespace brunt::scene {

/// Reads a scene from its YAML text. `file_name` appears in messages, and mesh files are found relative to its folder.
/// `overrides` are `key.path=value` changes (`--set`), applied in order before reading. Throws InputError with all
/// faults, one line each: `FILE:LINE: key.path: what is wrong; expected ...`.
Input read_scene(const std::string& text, const std::string& file_name, std::span<const std::string> overrides = {});

}  // namespace brunt::scene
