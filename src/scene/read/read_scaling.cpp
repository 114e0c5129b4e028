// SPDX-License-Identifier: Apache-2.0
// The growth of a scene with the number of ranks: read for `scripts/scaling --weak`, which multiplies the named values.
// A run of the scene only checks that they exist.
#include <fmt/format.h>

#include <algorithm>

#include "core/excerpt.hpp"
#include "scene/read/sections.hpp"

namespace brunt::scene {
namespace {

std::vector<std::string> steps_of(const std::string& path) {
  std::vector<std::string> steps(1);
  for (const char c : path)
    if (c == '.')
      steps.emplace_back();
    else
      steps.back() += c;
  return steps;
}

/// Children that a step of a path leads to: an entry of a map, an entry of a list, or with `*` every one.
std::vector<const Tree*> children(const Tree& tree, const std::string& step) {
  std::vector<const Tree*> found;
  for (std::size_t i = 0; i < tree.children.size(); ++i) {
    const std::string name = tree.kind == Tree::Kind::map ? tree.keys[i] : fmt::format("{}", i);
    if (step == "*" || step == name) found.push_back(&tree.children[i]);
  }
  return found;
}

std::vector<const Tree*> values_at(const Tree& scene, const std::string& path) {
  std::vector<const Tree*> found{&scene};
  std::string walked;
  for (const std::string& step : steps_of(path)) {
    std::vector<const Tree*> next;
    for (const Tree* tree : found) {
      const bool lone_mesh = walked == "mesh" && tree->kind == Tree::Kind::map && (step == "0" || step == "*");
      const std::vector<const Tree*> below = lone_mesh ? std::vector{tree} : children(*tree, step);
      next.insert(next.end(), below.begin(), below.end());
    }
    walked = step;
    found = std::move(next);
  }
  return found;
}

bool is_count(const Tree& value) {
  Findings aside;
  GlobalIndex count = 0;
  return read(Key{&value, value.place, "", &aside}, count, Count{1});
}
bool is_number(const Tree& value) {
  Findings aside;
  double number = 0;
  return read(Key{&value, value.place, "", &aside}, number, any_number);
}

/// The values that a list of paths may name.
struct Kind {
  bool (*is_good)(const Tree&);
  std::string_view step;  ///< required in the path, if any
  std::string_view expected;
};
constexpr Kind counts{is_count, "elements", "paths of numbers of elements, such as mesh.0.box.elements.0"};
constexpr Kind lengths{is_number, "", "paths of numbers, such as mesh.0.box.size.0"};

void check_paths(Section& direction, std::string_view name, const Tree& scene, const Kind& kind) {
  if (!direction.has(name)) return;
  const std::string_view step = kind.step, expected = kind.expected;
  const std::string list = fmt::format("a list of {}", expected);
  const std::vector<Key> entries = items(direction.at(name), list);
  if (entries.empty() && direction.at(name).tree->kind == Tree::Kind::list && !step.empty())
    fault(direction.at(name), fmt::format("missing entries; expected {}", list));
  for (const Key& entry : entries) {
    std::string path;
    if (!read(entry, path, expected)) continue;
    const std::vector<const Tree*> values = values_at(scene, path);
    if (const std::vector<std::string> steps = steps_of(path);
        !step.empty() && std::ranges::find(steps, step) == steps.end()) {
      fault(entry, fmt::format("invalid path '{}': not a number of elements; expected {}", excerpt(path), expected));
    } else if (values.empty()) {
      fault(entry, fmt::format("unknown path '{}' in this scene; expected {}", excerpt(path), expected));
    } else if (const auto bad =
                   std::ranges::find_if_not(values, [&good = kind.is_good](const Tree* v) { return good(*v); });
               bad != values.end()) {
      const std::string there =
          (*bad)->kind == Tree::Kind::value ? fmt::format("'{}'", excerpt((*bad)->text)) : "no value";
      fault(entry, fmt::format("invalid path '{}': it leads to {}; expected {}", excerpt(path), there, expected));
    }
  }
}

}  // namespace

void read_scaling(Section& scene) {
  if (!scene.has("scaling")) return;
  Section scaling(scene.at("scaling"), "a map {weak: [{counts: [...], lengths: [...]}, ...]}");
  if (!scaling.is_map()) return;
  if (!scaling.has("weak")) return lacking(scaling.key(), {"weak"}, "missing growth; expected weak: [{counts: [...]}]");
  constexpr std::string_view one_to_three = "a list of one to three directions {counts: [...], lengths: [...]}";
  const Key weak = scaling.at("weak");
  const std::vector<Key> directions = items(weak, one_to_three);
  if (weak.tree->kind == Tree::Kind::list && (directions.empty() || directions.size() > 3))
    fault(weak, fmt::format("invalid list of {} directions; expected {}", directions.size(), one_to_three));
  for (const Key& key : directions) {
    Section direction(key, "a map {counts: [...], lengths: [...]}");
    if (direction.is_map() && !direction.has("counts"))
      lacking(direction.key(), {"counts"}, "missing counts; expected counts: [mesh.0.box.elements.0]");
    check_paths(direction, "counts", *scene.key().tree, counts);
    check_paths(direction, "lengths", *scene.key().tree, lengths);
  }
}

}  // namespace brunt::scene
