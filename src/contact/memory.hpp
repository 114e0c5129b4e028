// SPDX-License-Identifier: Apache-2.0
// Access to large arrays with prefetching.
#pragma once
#include <cstddef>
#include <span>
#include <vector>

namespace brunt::contact {

template <class T>
std::span<double> as_doubles(std::vector<T>& values) {
  return {reinterpret_cast<double*>(values.data()), values.size() * sizeof(T) / sizeof(double)};
}

/// Surface nodes are far apart in memory, and the data of all nodes do not fit the cache: they are prefetched this many
/// nodes ahead.
constexpr std::size_t far_ahead = 16;

}  // namespace brunt::contact
