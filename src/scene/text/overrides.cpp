// SPDX-License-Identifier: Apache-2.0
#include "scene/text/overrides.hpp"

#include <fmt/format.h>

#include <charconv>
#include <optional>

#include "core/excerpt.hpp"

namespace brunt::scene {
namespace {

std::vector<std::string> steps_of(const std::string& path) {
  std::vector<std::string> steps(1);
  for (const char c : path) {
    if (c == '.') {
      steps.emplace_back();
    } else {
      steps.back() += c;
    }
  }
  return steps;
}

Tree* list_entry(Tree& list, const std::string& step, const std::string& path, const Place& place, Faults& faults) {
  std::size_t index = list.children.size();
  const char* last = step.data() + step.size();
  const auto [end, error] = std::from_chars(step.data(), last, index);
  if (error == std::errc{} && end == last && index < list.children.size()) return &list.children[index];
  faults.add(place, path,
             fmt::format("out of range: the list has no such entry; expected an index from 0, below {}",
                         list.children.size()));
  return nullptr;
}

Tree* map_entry(Tree& map, const std::string& step, const Place& place) {
  if (Tree* found = map.find(step)) return found;
  map.kind = Tree::Kind::map;
  map.keys.push_back(step);
  map.children.push_back(Tree{.place = place});
  return &map.children.back();
}

void erase(Tree& map, const std::string& key) {
  for (std::size_t i = 0; i < map.keys.size(); ++i) {
    if (map.keys[i] != key) continue;
    map.keys.erase(map.keys.begin() + static_cast<std::ptrdiff_t>(i));
    map.children.erase(map.children.begin() + static_cast<std::ptrdiff_t>(i));
    return;
  }
}

void apply(Tree& scene, const std::string& path, const Tree& value, const Place& place, Faults& faults) {
  const std::vector<std::string> steps = steps_of(path);
  Tree* at = &scene;
  Tree* parent = nullptr;
  std::string walked;
  for (const std::string& step : steps) {
    const bool lone_mesh = walked == "mesh" && at->kind == Tree::Kind::map && step == "0";
    walked += (walked.empty() ? "" : ".") + step;
    if (lone_mesh) continue;  // a mesh of one body may be written without a list
    if (at->kind == Tree::Kind::value) {
      faults.add(place, walked,
                 "invalid path: the key above it has a single value; expected a path through maps and lists");
      return;
    }
    parent = at;
    at = at->kind == Tree::Kind::list ? list_entry(*at, step, walked, place, faults) : map_entry(*at, step, place);
    if (at == nullptr) return;
  }
  const bool take_away = value.kind == Tree::Kind::null && parent != nullptr && parent->kind == Tree::Kind::map;
  if (take_away) return erase(*parent, steps.back());
  *at = value;
}

}  // namespace

void apply_overrides(Tree& scene, std::span<const std::string> overrides, Faults& faults) {
  for (const std::string& override_text : overrides) {
    const Place place{"--set " + excerpt(override_text), 0};
    const std::size_t equals = override_text.find('=');
    const std::string path = override_text.substr(0, equals);
    const bool empty_step =
        path.empty() || path.front() == '.' || path.back() == '.' || path.find("..") != std::string::npos;
    if (equals == std::string::npos || empty_step) {
      faults.add(place, "", "invalid override; expected --set key.path=value, such as run.end=1.0e-5");
      continue;
    }
    if (override_text.find_first_not_of(" \t", equals + 1) == std::string::npos) {
      faults.add(place, "", "missing value; expected --set key.path=value (the value null removes the key)");
      continue;
    }
    const std::optional<Tree> value = parse_value(override_text.substr(equals + 1), place, faults);
    if (value) apply(scene, path, *value, place, faults);
  }
}

}  // namespace brunt::scene
