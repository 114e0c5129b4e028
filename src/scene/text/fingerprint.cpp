// SPDX-License-Identifier: Apache-2.0
#include "scene/text/fingerprint.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <sstream>
#include <string_view>
#include <utility>

#include "core/excerpt.hpp"
#include "model/hash.hpp"
#include "scene/text/overrides.hpp"
#include "scene/text/places.hpp"
#include "scene/text/tree.hpp"

namespace brunt::scene {
namespace {

constexpr std::array<std::string_view, 11> free_to_change{"title",     "output",         "scaling",           "history",
                                                          "guards",    "search",         "checkpoint",        "run.end",
                                                          "run.steps", "run.wall_limit", "run.min_step_ratio"};

/// A value of the scene, by the path of its key.
using Value = std::pair<std::string, std::string>;

/// Keys in alphabetical order, so that the order of keys in the file does not matter.
void append(const Tree& tree, const std::string& path, std::vector<Value>& values) {
  if (std::ranges::find(free_to_change, path) != free_to_change.end()) return;
  if (tree.kind == Tree::Kind::value) {
    values.emplace_back(path, tree.text);
    return;
  }
  std::vector<std::size_t> order(tree.children.size());
  for (std::size_t k = 0; k < order.size(); ++k) order[k] = k;
  if (tree.kind == Tree::Kind::map)
    std::ranges::sort(order, [&](std::size_t a, std::size_t b) { return tree.keys[a] < tree.keys[b]; });
  for (const std::size_t k : order) {
    const std::string name = tree.kind == Tree::Kind::map ? tree.keys[k] : fmt::format("{}", k);
    append(tree.children[k], path.empty() ? name : path + '.' + name, values);
  }
}

std::vector<Value> values_of(const std::string& text, const std::string& file_name,
                             std::span<const std::string> overrides) {
  Faults faults;
  Tree tree = parse_yaml(text, file_name, faults);
  if (tree.kind == Tree::Kind::null) return {};
  apply_overrides(tree, overrides, faults);
  std::vector<Value> values;
  append(tree, "", values);
  return values;
}

}  // namespace

std::string fingerprint(const std::string& text, const std::string& file_name, std::span<const std::string> overrides) {
  const std::vector<Value> values = values_of(text, file_name, overrides);
  if (values.empty()) return {};
  std::string flat;
  for (const auto& [path, value] : values) flat += path + '=' + value + ';';
  return model::hash_digits(model::hash_text(flat));
}

std::string decisive_values(const std::string& text, const std::string& file_name,
                            std::span<const std::string> overrides) {
  std::string lines;
  for (auto& [path, value] : values_of(text, file_name, overrides)) {
    std::ranges::replace(value, '\n', ' ');
    lines += path + '=' + value + '\n';
  }
  return lines;
}

std::vector<std::string> differences(const std::string& there, const std::string& here) {
  std::map<std::string, std::array<std::string, 2>> both;
  for (const std::size_t side : {0, 1}) {
    std::istringstream lines(side == 0 ? there : here);
    for (std::string line; std::getline(lines, line);) {
      const std::size_t equals = std::min(line.find('='), line.size());
      both[line.substr(0, equals)][side] = line.substr(std::min(equals + 1, line.size()));
    }
  }
  const auto reported = [](const std::string& value) { return value.empty() ? "not given" : excerpt(value); };
  std::vector<std::string> different;
  for (const auto& [path, values] : both)
    if (values[0] != values[1])
      different.push_back(fmt::format("{} is {} in the earlier run and {} in this scene", shown_path(path),
                                      reported(values[0]), reported(values[1])));
  return different;
}

}  // namespace brunt::scene
