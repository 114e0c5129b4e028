// SPDX-License-Identifier: Apache-2.0
#include "core/excerpt.hpp"

#include <cstddef>

#include "core/utf8.hpp"

namespace brunt {
namespace {

constexpr std::size_t longest = 60;  // characters: what a reader recognises at a glance

bool is_blank(char c) {
  return c == ' ' || c == '\t' || c == '\n' || c == '\r';
}

}  // namespace

std::string excerpt(std::string_view text) {
  std::string shown;
  for (std::size_t characters = 0; !text.empty(); ++characters) {
    if (characters == longest) return shown + "...";
    const std::size_t length = utf8_length(text);
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
