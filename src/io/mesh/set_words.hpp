// SPDX-License-Identifier: Apache-2.0
// Words by which a scene names the sets of a mesh file, where names and numbers may be the same text.
#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "core/types.hpp"

namespace brunt::io {

struct FileSet {
  GlobalIndex number = 0;
  std::string name{};  ///< empty where the file names none
};

/// A word of its own for each set: its name; without one, or if an earlier set has the name, its number; if this is the
/// name of another set, number_N. A note tells each set that has another word than its own name or number.
std::vector<std::string> set_words(std::string_view kind, const std::vector<FileSet>& sets,
                                   std::vector<std::string>& notes);

}  // namespace brunt::io
