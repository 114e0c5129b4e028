// SPDX-License-Identifier: Apache-2.0
#include "scene/text/nearest.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "core/excerpt.hpp"
#include "core/letter_case.hpp"

namespace brunt::scene {

int edit_distance(std::string_view a, std::string_view b) {
  std::vector<int> before(b.size() + 1), last(b.size() + 1), row(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) last[j] = static_cast<int>(j);
  for (std::size_t i = 1; i <= a.size(); ++i) {
    row[0] = static_cast<int>(i);
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const bool same = lower_case(a[i - 1]) == lower_case(b[j - 1]);
      row[j] = std::min({last[j] + 1, row[j - 1] + 1, last[j - 1] + (same ? 0 : 1)});
      const bool swapped = i > 1 && j > 1 && lower_case(a[i - 1]) == lower_case(b[j - 2]) &&
                           lower_case(a[i - 2]) == lower_case(b[j - 1]);
      if (swapped) row[j] = std::min(row[j], before[j - 2] + 1);
    }
    before.swap(last);
    last.swap(row);
  }
  return last[b.size()];
}

std::string nearest(std::string_view word, std::span<const std::string> known) {
  const auto best = std::min_element(known.begin(), known.end(), [&](const std::string& a, const std::string& b) {
    return edit_distance(word, a) < edit_distance(word, b);
  });
  return best == known.end() ? std::string{} : *best;
}

bool is_near(std::string_view word, std::string_view known) {
  return 2 * edit_distance(word, known) <= static_cast<int>(std::max<std::size_t>(known.size(), 2));
}

std::string did_you_mean(std::string_view word, std::span<const std::string> known) {
  const std::string meant = nearest(word, known);
  return !meant.empty() && is_near(word, meant) ? fmt::format(" (did you mean '{}'?)", excerpt(meant)) : "";
}

std::string listed(std::span<const std::string> words) {
  constexpr std::size_t most = 24;
  std::string text;
  for (std::size_t i = 0; i < std::min(words.size(), most); ++i) text += (i == 0 ? "" : ", ") + excerpt(words[i]);
  return words.size() > most ? text + ", ..." : text;
}

}  // namespace brunt::scene
