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

/// "a, b, c", at most two dozen.
std::string listed(std::span<const std::string> words);

}  // namespace brunt::scene
