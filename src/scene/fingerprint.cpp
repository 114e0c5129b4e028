// SPDX-License-Identifier: Apache-2.0
#include "brunt/scene/fingerprint.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>

#include "brunt/model/hash.hpp"
#include "brunt/scene/overrides.hpp"
#include "brunt/scene/tree.hpp"

namespace brunt::scene {
namespace {

constexpr std::array<std::string_view, 7> free_to_change{"title",   "output",    "history",       "checkpoint",
                                                         "run.end", "run.steps", "run.wall_limit"};

/// Keys in alphabetical order, so that a scene written in another order is the same scene.
void append(const Tree& tree, const std::string& path, std::string& text) {
  if (std::ranges::find(free_to_change, path) != free_to_change.end()) return;
  if (tree.kind == Tree::Kind::value) {
    text += path + '=' + tree.text + ';';
    return;
  }
  std::vector<std::size_t> order(tree.children.size());
  for (std::size_t k = 0; k < order.size(); ++k) order[k] = k;
  if (tree.kind == Tree::Kind::map)
    std::ranges::sort(order, [&](std::size_t a, std::size_t b) { return tree.keys[a] < tree.keys[b]; });
  for (const std::size_t k : order) {
    const std::string name = tree.kind == Tree::Kind::map ? tree.keys[k] : fmt::format("{}", k);
    append(tree.children[k], path.empty() ? name : path + '.' + name, text);
  }
}

}  // namespace

std::string fingerprint(const std::string& text, const std::string& file_name, std::span<const std::string> overrides) {
  Faults faults;
  Tree tree = parse_yaml(text, file_name, faults);
  if (tree.kind == Tree::Kind::null) return {};
  apply_overrides(tree, overrides, faults);
  std::string flat;
  append(tree, "", flat);
  return model::hash_digits(model::hash_text(flat));
}

}  // namespace brunt::scene
