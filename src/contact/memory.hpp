// SPDX-License-Identifier: Apache-2.0
// How contact's files see arrays, and when they ask for them.
#pragma once
#include <cstddef>
#include <span>
#include <vector>

namespace brunt::contact {

template <class T>
std::span<double> as_doubles(std::vector<T>& values) {
  return {reinterpret_cast<double*>(values.data()), values.size() * sizeof(T) / sizeof(double)};
}

/// Nodes on the surface lie apart from each other, and what all nodes have does not fit the cache: they are asked for
/// so many nodes before they are needed.
constexpr std::size_t far_ahead = 16;

}  // namespace brunt::contact
