// SPDX-License-Identifier: Apache-2.0
#include "scene/text/reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>

#include "commas.hpp"
#include "core/excerpt.hpp"
#include "scene/text/nearest.hpp"
#include "scene/text/places.hpp"

namespace brunt::scene {
namespace {

std::string described(const Key& key) {
  if (key.tree == nullptr) return "missing";
  switch (key.tree->kind) {
    case Tree::Kind::null:
      return "missing value";
    case Tree::Kind::list:
      return fmt::format("invalid list of {} entries", key.tree->children.size());
    case Tree::Kind::map:
      return "invalid map";
    default:
      return fmt::format("invalid {} '{}'", key.tree->quoted ? "quoted text" : "value", excerpt(key.tree->text));
  }
}

bool is_plain_value(const Key& key) {
  return key.tree != nullptr && key.tree->kind == Tree::Kind::value && !key.tree->quoted;
}

/// A complete number, such as 3, -2.5, 80.0e-6, .5; also inf and nan, which the caller rejects.
std::optional<double> number_in(const Key& key) {
  if (!is_plain_value(key)) return {};
  std::string_view text = key.tree->text;
  if (text.size() > 1 && text[0] == '+' && text[1] != '-') text.remove_prefix(1);
  if (text == ".inf" || text == "-.inf" || text == ".nan") return infinity;
  double number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (end != text.data() + text.size()) return {};
  return error == std::errc{} ? number : infinity;
}

Key child(const Key& parent, const Tree& tree, std::string_view name) {
  return {&tree, tree.place, fmt::format("{}{}{}", parent.path, parent.path.empty() ? "" : ".", name), parent.findings};
}

/// The known key that a misspelt one is nearest to: preferably one that the map lacks, whose fault is taken back.
std::string meant_key(const Key& map, const std::string& name, std::span<const std::string> known) {
  std::string meant = nearest(name, known);
  std::vector<Missing>& missing = map.findings->missing;
  for (auto lack = missing.begin(); lack != missing.end(); ++lack) {
    if (lack->path != map.path) continue;
    std::string wanted = nearest(name, lack->names);
    if (!is_near(name, wanted) || edit_distance(name, wanted) > edit_distance(name, meant)) continue;
    map.findings->faults.take_back(lack->fault);
    missing.erase(lack);
    return wanted;
  }
  return meant;
}

}  // namespace

void fault(const Key& key, std::string_view what) {
  key.findings->faults.add(key.place, key.path, what);
}

std::string place_of(const Key& key) {
  const std::string where =
      key.place.line > 0 ? fmt::format("{}:{}", key.place.source, key.place.line) : key.place.source;
  return fmt::format("{}: {}", where, shown_path(key.path));
}

bool wrong(const Key& key, std::string_view expected) {
  const std::size_t number =
      key.findings->faults.add(key.place, key.path, fmt::format("{}; expected {}", described(key), expected));
  if (key.tree == nullptr) {
    const std::size_t dot = key.path.rfind('.');
    const bool top = dot == std::string::npos;
    key.findings->missing.push_back(
        {top ? "" : key.path.substr(0, dot), {top ? key.path : key.path.substr(dot + 1)}, number});
  }
  return false;
}

void warn(const Key& key, std::string_view what) {
  key.findings->warnings.push_back(fmt::format("{}: {}", place_of(key), what));
}

void lacking(const Key& map, std::vector<std::string> names, std::string_view what) {
  map.findings->missing.push_back({map.path, std::move(names), map.findings->faults.add(map.place, map.path, what)});
}

bool is_map(const Key& key) {
  return key.tree != nullptr && key.tree->kind == Tree::Kind::map;
}

bool is_list(const Key& key) {
  return key.tree != nullptr && key.tree->kind == Tree::Kind::list;
}

bool is_value(const Key& key) {
  return key.tree != nullptr && key.tree->kind == Tree::Kind::value;
}

bool has(const Key& map, std::string_view name) {
  return is_map(map) && map.tree->find(name) != nullptr;
}

Key at(const Key& map, std::string_view name) {
  if (has(map, name)) return child(map, *map.tree->find(name), name);
  return {nullptr, map.place, fmt::format("{}{}{}", map.path, map.path.empty() ? "" : ".", name), map.findings};
}

Key scene_of(const Key& key) {
  const Tree* scene = key.findings->scene;
  return {scene, scene->place, "", key.findings};
}

Key at(const Key& list, std::size_t entry) {
  return child(list, list.tree->children[entry], std::to_string(entry));
}

bool demand(const Key& map, std::string_view name, std::string_view expected) {
  return has(map, name) || wrong(at(map, name), expected);
}

bool demand_one(const Key& map, std::vector<std::string> names, std::string_view missing, std::string_view several) {
  const auto given = std::ranges::count_if(names, [&](const std::string& name) { return has(map, name); });
  if (given > 1) fault(map, several);
  if (given == 0) lacking(map, std::move(names), missing);
  return given == 1;
}

void refuse_any(const Key& map, std::initializer_list<const char*> names, std::string_view what) {
  for (const char* name : names)
    if (has(map, name)) fault(at(map, name), what);
}

bool later(const Key& key, std::string_view what, std::string_view expected) {
  fault(key, fmt::format("unknown in this version: {}; expected {}", what, expected));
  return false;
}

bool Range::holds(double x) const {
  return (low_included ? x >= low : x > low) && (high_included ? x <= high : x < high);
}

bool read(const Key& key, double& target, const Range& range) {
  const std::optional<double> number = number_in(key);
  if (!number) return !comma_in_value(key, range.words) && wrong(key, range.words);
  if (!std::isfinite(*number)) {
    fault(key, fmt::format("invalid value {}: not a finite number; expected {}", excerpt(key.tree->text), range.words));
    return false;
  }
  if (!range.holds(*number)) {
    fault(key, fmt::format("out of range: {}; expected {}", excerpt(key.tree->text), range.words));
    return false;
  }
  target = *number;
  return true;
}

bool read(const Key& key, GlobalIndex& target, Count count) {
  const std::string expected = fmt::format("an integer from {} to {}", count.low, count.high);
  const std::optional<double> number = number_in(key);
  if (!number) return !comma_in_value(key, expected) && wrong(key, expected);
  constexpr double exact = 9007199254740992.0;  // 2^53: integers up to this value are exact doubles
  const bool integer = std::abs(*number) < exact && std::trunc(*number) == *number;
  const GlobalIndex value = integer ? static_cast<GlobalIndex>(*number) : 0;
  if (!integer || value < count.low || value > count.high) {
    fault(key, fmt::format("{}; expected {}", integer ? "out of range: " + excerpt(key.tree->text) : described(key),
                           expected));
    return false;
  }
  target = value;
  return true;
}

bool read(const Key& key, int& target, Count count) {
  GlobalIndex value = 0;
  if (!read(key, value, count)) return false;
  target = static_cast<int>(value);
  return true;
}

bool read(const Key& key, bool& target) {
  const bool yes = is_plain_value(key) && key.tree->text == "true";
  const bool no = is_plain_value(key) && key.tree->text == "false";
  if (!yes && !no) return wrong(key, "true or false");
  target = yes;
  return true;
}

bool read(const Key& key, std::string& target, std::string_view expected) {
  if (key.tree == nullptr || key.tree->kind != Tree::Kind::value || key.tree->text.empty()) return wrong(key, expected);
  target = key.tree->text;
  return true;
}

bool read(const Key& key, std::string& target, Named kind) {
  constexpr std::array words{"the name of a material", "the name of a curve", "the name of a part",
                             "the name of a rigid wall", "the name of a joint"};
  if (!read(key, target, nth(words, kind))) return false;
  key.findings->references.push_back({key.place, key.path, target, kind});
  return true;
}

bool read(const Key& key, Vec3& target, Vector kind) {
  const bool direction = kind == Vector::direction;
  const std::string_view expected = direction ? "three numbers [x, y, z], not all zero" : "three numbers [x, y, z]";
  std::array<double, 3> numbers{};
  if (!read(key, numbers, any_number, expected)) return false;
  const Vec3 vector(numbers[0], numbers[1], numbers[2]);
  if (direction && !(vector.cwiseAbs().maxCoeff() > 0)) {
    fault(key, fmt::format("invalid direction: the zero vector; expected {}", expected));
    return false;
  }
  target = direction ? vector.stableNormalized() : vector;
  return true;
}

std::vector<Key> items(const Key& key, std::string_view expected, std::size_t size) {
  const bool is_list = key.tree != nullptr && key.tree->kind == Tree::Kind::list;
  if (!is_list || (size != 0 && key.tree->children.size() != size)) {
    wrong(key, std::string(expected) + (is_list ? comma_in_list(*key.tree, size) : ""));
    return {};
  }
  std::vector<Key> keys;
  for (const Tree& entry : key.tree->children) keys.push_back(child(key, entry, std::to_string(keys.size())));
  return keys;
}

std::vector<std::pair<std::string, Key>> entries(const Key& key, std::string_view expected) {
  if (key.tree == nullptr || key.tree->kind != Tree::Kind::map) {
    wrong(key, expected);
    return {};
  }
  std::vector<std::pair<std::string, Key>> named;
  for (std::size_t i = 0; i < key.tree->keys.size(); ++i) {
    const std::string& name = key.tree->keys[i];
    named.emplace_back(name, child(key, key.tree->children[i], name));
    if (name.empty()) fault(named.back().second, "invalid empty name; expected a name");
  }
  return named;
}

std::size_t read_choice(const Key& key, const std::vector<std::string>& now, const std::vector<std::string>& not_yet) {
  const std::string expected = (now.size() > 1 ? "one of " : "") + listed(now);
  std::string word;
  if (!read(key, word, expected)) return now.size();
  for (std::size_t i = 0; i < now.size(); ++i) {
    if (now[i] == word) return i;
  }
  for (const std::string& known : not_yet) {
    if (known != word) continue;
    later(key, "'" + word + "'", expected);
    return now.size();
  }
  fault(key, fmt::format("unknown value '{}'{}; expected {}", excerpt(word), did_you_mean(word, now), expected));
  return now.size();
}

bool read(const Key& key, std::span<bool> marked, const Choices<int>& directions) {
  std::vector<std::string> names;
  for (const auto& choice : directions.now) names.push_back(choice.first);
  const std::string expected = fmt::format("a list of {}", fmt::join(names, ", "));
  const std::vector<Key> named = items(key, expected);
  bool good = !named.empty();
  for (const Key& one : named) {
    int direction = 0;
    if (!read(one, direction, directions)) {
      good = false;
      continue;
    }
    bool& mark = nth(marked, direction);
    if (mark)
      fault(one, fmt::format("invalid direction '{}': listed twice; expected each direction once", one.tree->text));
    good = good && !mark;
    mark = true;
  }
  const bool empty_list = named.empty() && key.tree != nullptr && key.tree->kind == Tree::Kind::list;
  return empty_list ? wrong(key, expected) : good;
}

void refuse_unknown(const Key& map, std::span<const std::string> known, std::span<const std::string> silent) {
  for (const std::string& name : map.tree->keys) {
    if (std::ranges::find(known, name) != known.end() || std::ranges::find(silent, name) != silent.end()) continue;
    const std::string meant = meant_key(map, name, known);
    fault(at(map, name),
          fmt::format("unknown key{}; expected one of {}", did_you_mean(name, std::span(&meant, 1)), listed(known)));
  }
}

}  // namespace brunt::scene
