// SPDX-License-Identifier: Apache-2.0
#include "scene/text/duration.hpp"

#include <array>
#include <charconv>
#include <cmath>

namespace brunt::scene {
namespace {

struct Unit {
  char letter;
  double seconds;
};
constexpr std::array<Unit, 4> units{{{'d', 86400}, {'h', 3600}, {'m', 60}, {'s', 1}}};

}  // namespace

std::optional<double> parse_duration(std::string_view text) {
  double total = 0;
  std::size_t next_unit = 0;
  const char* at = text.data();
  const char* const end = at + text.size();
  while (at != end) {
    double number = 0;
    const auto parsed = std::from_chars(at, end, number);
    if (parsed.ec != std::errc{} || !std::isfinite(number) || number < 0) return {};
    const bool bare = parsed.ptr == end;
    if (bare && at != text.data()) return {};
    const char letter = bare ? 's' : *parsed.ptr;
    while (next_unit < units.size() && units[next_unit].letter != letter) ++next_unit;
    if (next_unit == units.size()) return {};
    total += number * units[next_unit].seconds;
    ++next_unit;
    at = bare ? end : parsed.ptr + 1;
  }
  return total > 0 ? std::optional(total) : std::nullopt;
}

}  // namespace brunt::scene
