// SPDX-License-Identifier: Apache-2.0
// What is said of the keys of a scene. The scene reference, `brunt info --keys` and the schema of editors are written
// from it.
#pragma once
#include <string>
#include <vector>

namespace brunt::scene {

/// One row of the reference. Texts are Markdown.
struct Said {
  std::string key;
  std::vector<std::string> of;  ///< kinds of bodies, or models of materials, that have the key; empty: all
  std::string type;             ///< type and range of the value
  std::string unit;             ///< dimension in the units of the scene; "-" for a pure number or a word
  std::string fallback;         ///< the value of a missing key; "required" or "required, or ...", or "none"
  std::string meaning;
};

/// The keys of one map.
struct Described {
  std::string name;  ///< "run", "contact.friction"; "scene" for the top level
  std::vector<Said> rows;
  std::vector<const Described*> inner;  ///< maps that are values of these keys, in the order of the rows
};

/// The whole table of keys: the top level, and below each map those inside it.
std::vector<const Described*> all_keys();

}  // namespace brunt::scene
