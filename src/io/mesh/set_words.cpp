// SPDX-License-Identifier: Apache-2.0
#include "set_words.hpp"

#include <fmt/core.h>

#include <set>

#include "core/excerpt.hpp"

namespace brunt::io {

std::vector<std::string> set_words(std::string_view kind, const std::vector<FileSet>& sets,
                                   std::vector<std::string>& notes) {
  std::set<std::string> taken;
  std::vector<std::string> words(sets.size());
  for (std::size_t k = 0; k < sets.size(); ++k)
    if (!sets[k].name.empty() && taken.insert(sets[k].name).second) words[k] = sets[k].name;
  for (std::size_t k = 0; k < sets.size(); ++k) {
    if (!words[k].empty()) continue;
    const std::string number = std::to_string(sets[k].number);
    words[k] = number;
    while (!taken.insert(words[k]).second) words[k] = "number_" + words[k];
    const std::string& clash = sets[k].name.empty() ? number : sets[k].name;
    if (!sets[k].name.empty() || words[k] != number)
      notes.push_back(fmt::format("{} {}: another {} has the name '{}': this one is called '{}' here", kind, number,
                                  kind, excerpt(clash), words[k]));
  }
  return words;
}

}  // namespace brunt::io
