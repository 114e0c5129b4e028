// SPDX-License-Identifier: Apache-2.0
// A number from the bytes of a binary file, at any address and of either byte order.
#pragma once
#include <algorithm>
#include <array>
#include <bit>
#include <cstring>

namespace brunt::io {

template <class T>
[[nodiscard]] inline T raw_number(const char* bytes, std::endian order) {
  std::array<char, sizeof(T)> own;
  std::memcpy(own.data(), bytes, sizeof(T));
  if (order != std::endian::native) std::reverse(own.begin(), own.end());
  return std::bit_cast<T>(own);
}

}  // namespace brunt::io
