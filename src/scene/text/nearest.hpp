// SPDX-License-Identifier: Apache-2.0
// The known word that is closest to a misspelt one.
#pragma once
#include <span>
#include <string>
#include <string_view>

namespace brunt::scene {

/// Edit distance: insertions, deletions, substitutions and swaps of neighbours, each 1 (optimal string alignment,
/// Damerau 1964); upper and lower case are the same letter.
int edit_distance(std::string_view a, std::string_view b);

/// The known word with the smallest edit distance, the first of equals; empty if there is none.
std::string nearest(std::string_view word, std::span<const std::string> known);

/// Whether a word may be a slip for a known one: at most half of the known one's letters differ, or one.
bool is_near(std::string_view word, std::string_view known);

/// " (did you mean 'x'?)" with the nearest known word, quoted by `excerpt`; empty if none is near.
std::string did_you_mean(std::string_view word, std::span<const std::string> known);

/// "a, b, c", at most two dozen.
std::string listed(std::span<const std::string> words);

}  // namespace brunt::scene
