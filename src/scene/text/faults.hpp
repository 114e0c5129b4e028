// SPDX-License-Identifier: Apache-2.0
// The faults of a scene: all are collected while it is read, then thrown together.
#pragma once
#include <string>
#include <string_view>
#include <vector>

namespace brunt::scene {

/// Where a piece of a scene was written.
struct Place {
  std::string source{};  ///< the scene file, or "--set key.path=value"
  int line = 0;          ///< in the file, from 1; 0 for an override
};

class Faults {
 public:
  /// One line: `FILE:LINE: key.path: what`; the path may be empty. Returns the number of the fault, for `take_back`.
  std::size_t add(const Place& place, std::string_view path, std::string_view what);
  /// Removes a fault that another one replaces.
  void take_back(std::size_t fault) { lines_[fault].text.clear(); }
  /// Throws InputError with all faults, those of the file by line, then those of overrides.
  void throw_if_any();

 private:
  struct Line {
    int line;
    std::string text;  ///< empty: taken back
  };
  std::vector<Line> lines_;
};

}  // namespace brunt::scene
