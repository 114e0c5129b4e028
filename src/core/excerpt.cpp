// SPDX-License-Identifier: Apache-2.0
#include "brunt/core/excerpt.hpp"

#include <cstddef>

namespace brunt {
namespace {

constexpr std::size_t longest = 60;  // characters: what a reader recognises at a glance

bool continues(char c) {
  return (static_cast<unsigned char>(c) & 0xC0U) == 0x80;
}

/// Bytes of the UTF-8 character at the beginning; 0 if there is none.
std::size_t length_of_character(std::string_view text) {
  const auto lead = static_cast<unsigned char>(text.front());
  const std::size_t length = lead < 0x80   ? 1
                             : lead < 0xC2 ? 0
                             : lead < 0xE0 ? 2
                             : lead < 0xF0 ? 3
                             : lead < 0xF5 ? 4
                                           : 0;
  if (length == 0 || length > text.size()) return 0;
  for (std::size_t k = 1; k < length; ++k)
    if (!continues(text[k])) return 0;
  return length;
}

bool is_blank(char c) {
  return c == ' ' || c == '\t' || c == '\n' || c == '\r';
}

}  // namespace

std::string excerpt(std::string_view text) {
  std::string shown;
  for (std::size_t characters = 0; !text.empty(); ++characters) {
    if (characters == longest) return shown + "...";
    const std::size_t length = length_of_character(text);
    const char first = text.front();
    if (length > 1)
      shown += text.substr(0, length);
    else if (is_blank(first))
      shown += ' ';
    else
      shown += length == 1 && first >= ' ' && first != '\x7f' ? first : '?';
    text.remove_prefix(length == 0 ? 1 : length);
  }
  return shown;
}

}  // namespace brunt
