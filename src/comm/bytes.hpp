// SPDX-License-Identifier: Apache-2.0
// Arrays as byte strings for messages between ranks.
#pragma once
#include <cstddef>
#include <cstring>
#include <span>
#include <vector>

namespace brunt::comm {

template <class T>
std::vector<T> array_of(std::span<const std::byte> bytes) {
  std::vector<T> values(bytes.size() / sizeof(T));
  if (!values.empty()) std::memcpy(values.data(), bytes.data(), values.size() * sizeof(T));
  return values;
}

}  // namespace brunt::comm
