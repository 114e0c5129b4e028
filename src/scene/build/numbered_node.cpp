// SPDX-License-Identifier: Apache-2.0
#include "numbered_node.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <optional>
#include <vector>

#include "core/excerpt.hpp"

namespace brunt::scene {
namespace {

std::optional<GlobalIndex> whole_number(std::string_view text) {
  GlobalIndex number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (text.empty() || error != std::errc{} || end != text.data() + text.size()) return {};
  return number;
}

/// What a text may mean: a node's number in the whole mesh, and how one would write it without doubt.
struct Meaning {
  GlobalIndex id;
  std::string described;
};

std::vector<Meaning> meanings(const mesh::Mesh& mesh, std::string_view text) {
  std::vector<Meaning> all;
  const std::optional<GlobalIndex> number = whole_number(text);
  for (const mesh::FilePiece& piece : mesh.files) {
    const bool prefixed = !number && !piece.prefix.empty() && text.starts_with(piece.prefix);
    const std::optional<GlobalIndex> own = prefixed ? whole_number(text.substr(piece.prefix.size())) : number;
    if (!own || *own + piece.node_shift < piece.first_node || *own + piece.node_shift > piece.last_node) continue;
    all.push_back({*own + piece.node_shift, piece.prefix.empty()
                                                ? fmt::format("that of {}", piece.file)
                                                : fmt::format("node: {}{} of {}", piece.prefix, *own, piece.file)});
  }
  const auto has = [&](GlobalIndex id) {
    return std::ranges::any_of(all, [&](const Meaning& one) { return one.id == id; });
  };
  if (number && !has(*number)) all.push_back({*number, fmt::format("node {} of the whole mesh", *number)});
  std::erase_if(all, [&](const Meaning& one) { return std::ranges::find(mesh.node_id, one.id) == mesh.node_id.end(); });
  return all;
}

}  // namespace

NumberedNode node_numbered(const mesh::Mesh& mesh, std::string_view text) {
  const std::vector<Meaning> all = meanings(mesh, text);
  if (all.size() == 1) {
    const auto found = std::ranges::find(mesh.node_id, all.front().id);
    return {static_cast<LocalIndex>(found - mesh.node_id.begin()), {}};
  }
  if (all.empty()) {
    const auto [lowest, highest] = std::ranges::minmax(mesh.node_id);
    return {no_index,
            fmt::format("unknown node {}; expected the number of one of the {} nodes of elements, from {} to {}, "
                        "or of a mesh file, with its prefix if it has one",
                        excerpt(text), mesh.node_id.size(), lowest, highest)};
  }
  std::vector<std::string> known;
  for (const Meaning& one : all) known.push_back(one.described);
  return {no_index,
          fmt::format("invalid node {}: several nodes have this number: {}; expected the prefix of a mesh file "
                      "before the number, or near: [x, y, z]",
                      excerpt(text), fmt::join(known, ", "))};
}

}  // namespace brunt::scene
