// SPDX-License-Identifier: Apache-2.0
// The growth of a scene with the number of ranks: read for `scripts/scaling --weak`, which multiplies the named values.
// A run of the scene only checks that they exist.
#include <fmt/format.h>

#include <algorithm>

#include "core/excerpt.hpp"
#include "scene/keys/table.hpp"
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

/// Reads a list of paths, and checks the values that they lead to.
void read_paths(const Key& key, std::vector<std::string>& paths, const Kind& kind) {
  const std::string_view step = kind.step, expected = kind.expected;
  const std::string list = fmt::format("a list of {}", expected);
  const std::vector<Key> entries = items(key, list);
  if (entries.empty() && is_list(key) && !step.empty()) fault(key, fmt::format("missing entries; expected {}", list));
  for (const Key& entry : entries) {
    std::string& path = paths.emplace_back();
    if (!read(entry, path, expected)) continue;
    const std::vector<const Tree*> values = values_at(*key.findings->scene, path);
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

/// Paths of the values that are multiplied by the same factor.
struct Direction {
  std::vector<std::string> counts, lengths;
};
const Table<Direction> direction_keys{
    "scaling.weak",
    "a map {counts: [...], lengths: [...]}",
    {
        {"counts",
         special<Direction>("list", [](const Key& key, Direction& growth) { read_paths(key, growth.counts, counts); }),
         "-", "Key paths of numbers of elements that are multiplied; `*` stands for every entry of a list or map.",
         required},
        {"lengths",
         special<Direction>("list",
                            [](const Key& key, Direction& growth) { read_paths(key, growth.lengths, lengths); }),
         "-", "Key paths of numbers that are multiplied likewise, so that elements keep their shape."},
    },
};

struct Scaling {
  std::vector<Direction> weak;
};

void read_directions(const Key& key, Scaling& scaling) {
  constexpr std::string_view one_to_three = "a list of one to three directions {counts: [...], lengths: [...]}";
  const std::vector<Key> directions = items(key, one_to_three);
  if (is_list(key) && (directions.empty() || directions.size() > 3))
    fault(key, fmt::format("invalid list of {} directions; expected {}", directions.size(), one_to_three));
  for (const Key& direction : directions) direction_keys.read(direction, scaling.weak.emplace_back());
}

const Table<Scaling> scaling_keys{
    "scaling",
    "a map {weak: [{counts: [...], lengths: [...]}, ...]}",
    {
        {"weak", special("list", read_directions, {&direction_keys}), "-",
         "One to three directions of growth. The prime factors of the number of ranks are distributed over them.",
         required},
    },
};

}  // namespace

Value<Input> scaling_value() {
  return {.type = "map",
          .read =
              [](const Key& key, Input&) {
                Scaling checked_only;
                scaling_keys.read(key, checked_only);
              },
          .inner = {&scaling_keys}};
}

}  // namespace brunt::scene
