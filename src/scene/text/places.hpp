// SPDX-License-Identifier: Apache-2.0
// The places of the keys of a scene in its file, for faults that are found only after reading: in the mesh, or between
// bodies.
#pragma once
#include <map>
#include <string>
#include <string_view>

#include "scene/text/faults.hpp"

namespace brunt::scene {

/// A path as messages quote it: each name in it is an excerpt.
[[nodiscard]] std::string shown_path(std::string_view path);

class Places {
 public:
  /// `path`: as in messages, "contact.0.between.1".
  void note(const std::string& path, const Place& place) { places_.emplace(path, place); }
  [[nodiscard]] bool has(const std::string& path) const { return places_.contains(path); }
  /// "FILE:LINE: path" with the line of the key or, if it was not given, of the entry it belongs to; "FILE: path" if
  /// neither is known.
  [[nodiscard]] std::string name(std::string_view path, const std::string& file) const;

 private:
  std::map<std::string, Place, std::less<>> places_;
};

}  // namespace brunt::scene
