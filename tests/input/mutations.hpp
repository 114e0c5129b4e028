// SPDX-License-Identifier: Apache-2.0
// Random damage to the text or the bytes of a file.
#pragma once
#include <algorithm>
#include <random>
#include <string>
#include <vector>

namespace brunt::test {

class Mutations {
 public:
  explicit Mutations(unsigned seed) : random_(seed) {}

  std::string mutate(std::string text, const std::string& other) {
    for (std::size_t k = 1 + below(2) * below(4); k > 0; --k) change(text, other);
    return text;
  }

  std::size_t below(std::size_t limit) {
    return limit == 0 ? 0 : std::uniform_int_distribution<std::size_t>(0, limit - 1)(random_);
  }

 private:
  void change(std::string& text, const std::string& other) {
    const std::size_t at = below(text.size() + 1), length = std::min(below(64), text.size() - at);
    switch (below(8)) {
      case 0:  // a bit
        if (at < text.size()) text[at] = static_cast<char>(text[at] ^ (1 << below(8)));
        break;
      case 1:  // cut off
        text.resize(at);
        break;
      case 2:
        replace_number(text, at);
        break;
      case 3:  // a chunk once more
        text.insert(below(text.size() + 1), text.substr(at, length));
        break;
      case 4:  // a chunk less
        text.erase(at, length);
        break;
      case 5:  // bytes of a number
        replace_bytes(text, at);
        break;
      case 6:  // a chunk of another file
        text.insert(at, other.substr(below(other.size() + 1), below(200)));
        break;
      default:  // any byte
        text.insert(at, 1, static_cast<char>(below(256)));
    }
  }

  void replace_number(std::string& text, std::size_t at) {
    static const std::vector<std::string> numbers = {"0",
                                                     "-1",
                                                     "1",
                                                     "3",
                                                     "4",
                                                     "7",
                                                     "255",
                                                     "256",
                                                     "65536",
                                                     "nan",
                                                     "inf",
                                                     "-inf",
                                                     "1e400",
                                                     "1e39",
                                                     "1e-400",
                                                     "2147483647",
                                                     "2147483648",
                                                     "4294967295",
                                                     "-0",
                                                     "",
                                                     "1e308",
                                                     "1.5.5",
                                                     "0x1F",
                                                     "abc",
                                                     "99999999999999999999",
                                                     "9223372036854775807",
                                                     "1 1",
                                                     "\n",
                                                     "\\\n",
                                                     "-9223372036854775808"};
    const auto begin = text.find_first_of("0123456789", at);
    if (begin == std::string::npos) return;
    const auto end = std::min(text.find_first_not_of("0123456789.e-", begin), text.size());
    text.replace(begin, end - begin, numbers[below(numbers.size())]);
  }

  void replace_bytes(std::string& text, std::size_t at) {
    static const std::vector<std::string> values = {
        std::string(4, '\0'),           std::string(4, '\xFF'),         std::string("\xFF\xFF\xFF\x7F", 4),
        std::string("\0\0\x80\x7F", 4), std::string("\x7F\x80\0\0", 4), std::string(8, '\x7F'),
        std::string(1, '\xFF')};
    const std::string& value = values[below(values.size())];
    if (at + value.size() <= text.size()) text.replace(at, value.size(), value);
  }

  std::mt19937 random_;
};

}  // namespace brunt::test
