// SPDX-License-Identifier: Apache-2.0
#include "scene/keys/phrase.hpp"

#include <fmt/format.h>

#include <cmath>

namespace brunt::scene {

std::string quoted_list(const std::vector<std::string>& words) {
  return fmt::format("`{}`", fmt::join(words, "`, `"));
}

/// "a number > 0" of messages is "number > 0".
std::string phrase(double, const Range& range) {
  const std::string_view words = range.words;
  return std::string(words.substr(words.find(' ') + 1));
}

std::string phrase(GlobalIndex, Count count) {
  if (count.high < Count{}.high) return fmt::format("integer from {} to {}", count.low, count.high);
  return fmt::format("integer >= {}", count.low);
}

std::string phrase(bool) {
  return "`true`, `false`";
}

std::string phrase(const std::string&, const Text& text) {
  return std::string(text.type);
}

std::string phrase(const std::string&, Named) {
  return "name";
}

std::string phrase(const Vec3&, Vector kind) {
  return kind == Vector::direction ? "direction `[x, y, z]`" : "`[x, y, z]`";
}

/// "list of 3 numbers > 0".
std::string phrase_of_list(std::size_t size, const Range& range) {
  const std::string one = phrase(0.0, range);
  const std::size_t noun = one.find(' ');
  return fmt::format("list of {} {}s{}", size, one.substr(0, noun), noun == std::string::npos ? "" : one.substr(noun));
}

std::string shown(double number) {
  constexpr double least_plain = 0.01;
  if (number == 0 || std::abs(number) >= least_plain) return fmt::format("{}", number);
  const auto power = static_cast<int>(std::floor(std::log10(std::abs(number))));
  const std::string digits = fmt::format("{}", std::stod(fmt::format("{:.15g}", number * std::pow(10.0, -power))));
  return fmt::format("{}{}e{}", digits, digits.find('.') == std::string::npos ? ".0" : "", power);
}

std::string shown(const Vec3& vector) {
  return fmt::format("`[{}, {}, {}]`", vector[0], vector[1], vector[2]);
}

}  // namespace brunt::scene
