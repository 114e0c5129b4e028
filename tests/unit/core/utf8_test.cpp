// SPDX-License-Identifier: Apache-2.0
// Text in UTF-8, and text that is none.
#include "core/utf8.hpp"

#include <catch2/catch.hpp>

using brunt::as_utf8;
using brunt::utf8_length;

TEST_CASE("utf8: the length of a character, by its first byte") {
  CHECK(utf8_length("a") == 1);
  CHECK(utf8_length("\xC3\xA4z") == 2);
  CHECK(utf8_length("\xE2\x82\xAC") == 3);
  CHECK(utf8_length("\xF0\x9F\x94\xA9") == 4);
  for (const char* none : {"", "\xC3", "\x80", "\xC0\x80", "\xE2\x82x", "\xFF"}) CHECK(utf8_length(none) == 0);
}

TEST_CASE("utf8: UTF-8 stays, other text is Latin-1") {
  CHECK(as_utf8("").empty());
  CHECK(as_utf8("gr\xC3\xBCn") == "gr\xC3\xBCn");
  CHECK(as_utf8("gr\xFCn stra\xDF\x65") == "gr\xC3\xBCn stra\xC3\x9F\x65");
  CHECK(as_utf8("\xC3\xBC and \xFC") == "\xC3\x83\xC2\xBC and \xC3\xBC");  // no UTF-8 as a whole
}
