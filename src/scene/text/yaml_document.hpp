// SPDX-License-Identifier: Apache-2.0
// From text to the nodes of its single YAML document, with limited depth and size.
#pragma once
#include <yaml-cpp/yaml.h>

#include <optional>
#include <string>

#include "scene/text/faults.hpp"

namespace brunt::scene {

/// Largest number of nested levels of lists and maps. The deepest value of a scene has 7 (mesh.0.box.rotate.0.axis.0);
/// recursion over 64 levels takes a few tens of kilobytes of the stack.
constexpr int deepest_document = 64;

/// Largest number of values repeated by aliases (`*name`): three times a table of 10,000 points (30,000 values). Each
/// value takes about 0.3 kB, 30 MB in total. Values that are written out are not limited.
constexpr std::size_t most_repeated_values = 100'000;

/// A syntax error, a second document, an alias within its own anchor, too many levels and too many repeated values are
/// each one fault at the line (or, for an override with base.line 0, at `base`).
std::optional<YAML::Node> load_yaml(const std::string& text, const Place& base, Faults& faults);

}  // namespace brunt::scene
