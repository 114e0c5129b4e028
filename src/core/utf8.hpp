// SPDX-License-Identifier: Apache-2.0
// Names and text are UTF-8 in the program; old files are Latin-1.
#pragma once
#include <cstddef>
#include <string>
#include <string_view>

namespace brunt {

/// Bytes of the UTF-8 character at the beginning of a text; 0 if there is none (RFC 3629; overlong forms of three
/// and four bytes and surrogates pass).
[[nodiscard]] std::size_t utf8_length(std::string_view text);

/// The text itself if it is UTF-8, else the text read as Latin-1 (ISO 8859-1), of which each byte is a character.
[[nodiscard]] std::string as_utf8(std::string text);

}  // namespace brunt
