// SPDX-License-Identifier: Apache-2.0
// Quotations in messages.
#include "core/excerpt.hpp"

#include <catch2/catch.hpp>

using brunt::excerpt;

TEST_CASE("excerpt: short texts stay, long ones end after 60 characters") {
  CHECK(excerpt("").empty());
  CHECK(excerpt("density: 7800") == "density: 7800");
  CHECK(excerpt(std::string(60, 'x')) == std::string(60, 'x'));
  CHECK(excerpt(std::string(61, 'x')) == std::string(60, 'x') + "...");
}

TEST_CASE("excerpt: one line without control characters") {
  CHECK(excerpt("a\nb\r\n\tc") == "a b   c");
  CHECK(excerpt(std::string_view("a\0b\x1b[31m\x7f", 9)) == "a?b?[31m?");
}

TEST_CASE("excerpt: characters of UTF-8 remain whole, other bytes do not") {
  std::string text;
  for (int k = 0; k < 70; ++k) text += "\xC3\xA4";
  CHECK(excerpt(text) == text.substr(0, 120) + "...");
  CHECK(excerpt("\xE2\x82\xAC \xF0\x9F\x94\xA9") == "\xE2\x82\xAC \xF0\x9F\x94\xA9");
  CHECK(excerpt("\xC3") == "?");
  CHECK(excerpt("\xE2\x82x\xFF\xC0\x80") == "??x???");
}
