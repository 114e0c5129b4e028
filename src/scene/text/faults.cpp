// SPDX-License-Identifier: Apache-2.0
#include "scene/text/faults.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "core/error.hpp"
#include "scene/text/places.hpp"

namespace brunt::scene {

std::size_t Faults::add(const Place& place, std::string_view path, std::string_view what) {
  const bool in_file = place.line > 0;
  const std::string where = in_file ? fmt::format("{}:{}", place.source, place.line) : place.source;
  const int order = in_file ? place.line : std::numeric_limits<int>::max();
  lines_.push_back({order, path.empty() ? fmt::format("{}: {}", where, what)
                                        : fmt::format("{}: {}: {}", where, shown_path(path), what)});
  return lines_.size() - 1;
}

void Faults::throw_if_any() {
  std::erase_if(lines_, [](const Line& line) { return line.text.empty(); });
  if (lines_.empty()) return;
  std::stable_sort(lines_.begin(), lines_.end(), [](const Line& a, const Line& b) { return a.line < b.line; });
  std::vector<std::string> texts;
  for (const Line& line : lines_)  // a key that stands many times on one line is one fault
    if (std::ranges::find(texts, line.text) == texts.end()) texts.push_back(line.text);
  throw InputError(std::move(texts));
}

}  // namespace brunt::scene
