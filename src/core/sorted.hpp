// SPDX-License-Identifier: Apache-2.0
// Sorted arrays. The ranges of C++20 that return a subrange (unique, equal_range) are avoided: clang 14, which checks
// the sources, cannot read those of g++ 12.
#pragma once
#include <algorithm>
#include <span>
#include <vector>

namespace brunt {

/// Sorts the values and keeps one of those that are equal.
template <class T>
void sort_unique(std::vector<T>& values) {
  std::ranges::sort(values);
  values.erase(std::unique(values.begin(), values.end()), values.end());
}

/// The values whose member is equal to the key; sorted by this member.
template <class T, class Key>
[[nodiscard]] std::span<const T> equal_part(const std::vector<T>& sorted, const Key& key, Key T::*member) {
  return {std::ranges::lower_bound(sorted, key, {}, member), std::ranges::upper_bound(sorted, key, {}, member)};
}

}  // namespace brunt
