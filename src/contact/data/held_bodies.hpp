// SPDX-License-Identifier: Apache-2.0
// The bodies with which a contact node has mortar rows.
#pragma once
#include <array>
#include <cstdint>

namespace brunt::contact {

/// Two at most: a third one is met by rows of nodes on faces besides.
struct HeldBodies {
  std::array<double, 2> body{};  ///< body + 1, or 0; numbers that exchanges of nodes share

  [[nodiscard]] bool has(std::int32_t wanted) const { return body[0] == wanted + 1 || body[1] == wanted + 1; }
  void add(std::int32_t other) {
    if (has(other)) return;
    if (body[0] == 0)
      body[0] = other + 1;
    else if (body[1] == 0)
      body[1] = other + 1;
  }
};
constexpr int held_bodies_width = 2;

}  // namespace brunt::contact
