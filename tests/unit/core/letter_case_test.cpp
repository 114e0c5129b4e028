// SPDX-License-Identifier: Apache-2.0
// Upper and lower case of every byte.
#include "core/letter_case.hpp"

#include <catch2/catch.hpp>
#include <string>
#include <string_view>

using brunt::lower_case;
using brunt::upper_case;

TEST_CASE("letter case: the letters of ASCII change, and no other byte") {
  constexpr std::string_view capitals = "ABCDEFGHIJKLMNOPQRSTUVWXYZ", small = "abcdefghijklmnopqrstuvwxyz";
  for (int byte = 0; byte < 256; ++byte) {
    const char c = static_cast<char>(byte);
    CAPTURE(byte);
    const std::size_t capital = capitals.find(c), letter = small.find(c);
    CHECK(lower_case(c) == (capital == std::string_view::npos ? c : small[capital]));
    CHECK(upper_case(c) == (letter == std::string_view::npos ? c : capitals[letter]));
  }
}

TEST_CASE("letter case: texts") {
  CHECK(lower_case(std::string_view("*Node, NSET=\xC3\x84x")) == "*node, nset=\xC3\x84x");
  CHECK(upper_case(std::string_view("s1_\xC3\xA4")) == "S1_\xC3\xA4");
  CHECK(lower_case(std::string_view()).empty());
}
