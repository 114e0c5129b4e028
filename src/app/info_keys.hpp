// SPDX-License-Identifier: Apache-2.0
// The table of keys of a scene, for `brunt info --keys`.
#pragma once
#include <string>

namespace brunt::app {

/// To be read: the path of each key with its type, unit and default, and below it its meaning.
[[nodiscard]] std::string keys_as_text();

/// For programs: a list of {"map", "keys"}, a key with "key", "of", "type", "unit", "default" and "meaning", in
/// Markdown.
[[nodiscard]] std::string keys_as_json();

}  // namespace brunt::app
