// SPDX-License-Identifier: Apache-2.0
// Typed reading of the tree of a scene. Each `read` checks one value. If it is wrong, it adds a fault with the expected
// value and leaves the target unchanged.
#pragma once
#include <array>
#include <initializer_list>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/types.hpp"
#include "scene/text/tree.hpp"

namespace brunt::scene {

/// The kinds of objects that a name in a scene may refer to.
enum class Named { material, curve, part, wall, joint };

/// A name that must be defined elsewhere in the scene; checked when everything has been read.
struct Reference {
  Place place;
  std::string path, name;
  Named kind;
};

/// A fault about missing keys. It is removed if one of them turns out to be misspelt.
struct Missing {
  std::string path;  ///< of the map that lacks them
  std::vector<std::string> names;
  std::size_t fault;
};

/// The findings of reading, beside the input itself.
struct Findings {
  Faults faults;
  std::vector<Missing> missing;
  std::vector<Reference> references;
  std::vector<std::string> warnings;  ///< of valid input
  const Tree* scene = nullptr;        ///< the whole scene
};

/// A value to read: its place in the tree (null if it is missing) and its name.
struct Key {
  const Tree* tree;
  Place place;  ///< of the value, or of the map that lacks it
  std::string path;
  Findings* findings;
};

void fault(const Key& key, std::string_view what);
/// "FILE:LINE: KEY PATH", without a line for a key of the command line: the beginning of warnings.
std::string place_of(const Key& key);
/// Adds the fault "missing; expected EXPECTED" or "invalid value 'TEXT'; expected EXPECTED". Always returns false, so
/// that a reader can return it.
bool wrong(const Key& key, std::string_view expected);
/// Adds a warning about a value: "FILE:LINE: KEY PATH: what".
void warn(const Key& key, std::string_view what);
/// The fault of a map that has none of the keys `names`.
void lacking(const Key& map, std::vector<std::string> names, std::string_view what);
/// The fault of a value or key of a later version. Always returns false.
bool later(const Key& key, std::string_view what, std::string_view expected);

[[nodiscard]] bool is_map(const Key& key);
[[nodiscard]] bool is_list(const Key& key);
[[nodiscard]] bool is_value(const Key& key);  ///< a word or number
/// Whether a map has a key.
[[nodiscard]] bool has(const Key& map, std::string_view name);
/// The value of a key of a map, or a missing one.
[[nodiscard]] Key at(const Key& map, std::string_view name);
/// The top level of the scene that has this value.
[[nodiscard]] Key scene_of(const Key& key);
/// The value of an entry of a list.
[[nodiscard]] Key at(const Key& list, std::size_t entry);
/// Adds the fault of a missing key to a map that lacks it. Returns whether the map has it.
bool demand(const Key& map, std::string_view name, std::string_view expected);
/// Judges keys of which a map must have exactly one: adds the fault `missing` or `several`.
bool demand_one(const Key& map, std::vector<std::string> names, std::string_view missing, std::string_view several);
/// The fault of keys that exclude each other: the one of each of `names` that the map has.
void refuse_any(const Key& map, std::initializer_list<const char*> names, std::string_view what);
/// Adds a fault, with the nearest known key, for each key of a map that is neither known nor `silent`.
void refuse_unknown(const Key& map, std::span<const std::string> known, std::span<const std::string> silent = {});

struct Range {
  double low, high;
  bool low_included, high_included;
  std::string_view words;
  [[nodiscard]] bool holds(double x) const;
};
constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr Range any_number{-infinity, infinity, false, false, "a number"};
constexpr Range positive{0, infinity, false, false, "a number > 0"};
constexpr Range not_negative{0, infinity, true, false, "a number >= 0"};
constexpr Range poisson_ratio{-1, 0.5, false, false, "a number > -1 and < 0.5"};
constexpr Range share{0, 1, true, true, "a number from 0 to 1"};
constexpr Range courant{0, 1, false, true, "a number > 0 and <= 1"};
constexpr Range below_one{0, 1, false, false, "a number > 0 and < 1"};

struct Count {
  GlobalIndex low;
  GlobalIndex high = std::numeric_limits<std::int32_t>::max();
};

enum class Vector { any, direction };  ///< a direction is not zero and is normalised

template <class Value>
struct Choices {
  std::vector<std::pair<std::string, Value>> now;
  std::vector<std::string> later;  ///< words of later versions
};

bool read(const Key& key, double& target, const Range& range);
bool read(const Key& key, GlobalIndex& target, Count count);
bool read(const Key& key, int& target, Count count);
bool read(const Key& key, bool& target);
bool read(const Key& key, std::string& target, std::string_view expected);
bool read(const Key& key, std::string& target, Named kind);  ///< also records the reference
bool read(const Key& key, Vec3& target, Vector kind);

template <class Value, class... How>
bool read(const Key& key, std::optional<Value>& target, const How&... how) {
  Value value{};
  if (!read(key, value, how...)) return false;
  target = value;
  return true;
}

/// Entries of a list of `size` entries (any number for 0); empty, with a fault, for anything else.
std::vector<Key> items(const Key& key, std::string_view expected, std::size_t size = 0);
/// Entries of a map of names; empty, with a fault, for anything else.
std::vector<std::pair<std::string, Key>> entries(const Key& key, std::string_view expected);

template <std::size_t N>
bool read(const Key& key, std::array<int, N>& target, Count count, std::string_view expected) {
  const std::vector<Key> counts = items(key, expected, N);
  bool good = counts.size() == N;
  for (std::size_t i = 0; i < counts.size(); ++i) good = read(counts[i], target[i], count) && good;
  return good;
}
template <std::size_t N>
bool read(const Key& key, std::array<double, N>& target, const Range& range, std::string_view expected) {
  const std::vector<Key> numbers = items(key, expected, N);
  bool good = numbers.size() == N;
  for (std::size_t i = 0; i < numbers.size(); ++i) good = read(numbers[i], target[i], range) && good;
  return good;
}

/// Position of the word in `now`; `now.size()`, with a fault, for any other word.
std::size_t read_choice(const Key& key, const std::vector<std::string>& now, const std::vector<std::string>& later);

template <class Value>
bool read(const Key& key, Value& target, const Choices<Value>& choices) {
  std::vector<std::string> now;
  for (const auto& choice : choices.now) now.push_back(choice.first);
  const std::size_t chosen = read_choice(key, now, choices.later);
  if (chosen < now.size()) target = choices.now[chosen].second;
  return chosen < now.size();
}

/// Whether a value is one of the words.
template <class Value>
bool is_word_of(const Choices<Value>& choices, const Key& key) {
  for (const auto& [word, value] : choices.now)
    if (is_value(key) && key.tree->text == word) return true;
  return false;
}

/// Marks the directions named in a list: at least one, and each at most once.
bool read(const Key& key, std::span<bool> marked, const Choices<int>& directions);

}  // namespace brunt::scene
