// SPDX-License-Identifier: Apache-2.0
#include "left_out.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "core/cells.hpp"
#include "core/error.hpp"
#include "core/excerpt.hpp"
#include "mesh/canonical.hpp"
#include "sound_mesh.hpp"

namespace brunt::io {
namespace {

using mesh::Block;
using mesh::Mesh;
using mesh::Side;

constexpr const char* by_ignore = "the key ignore of the mesh excludes it";

constexpr std::string_view by_number = "number_";

/// A word is the name of blocks; if none has it, a number. number_7 is number 7 also where another block has the
/// name 7.
template <class AnyBlock>
bool is_called(const AnyBlock& block, const std::string& word, bool is_name) {
  const std::string_view number = std::string_view(word).substr(word.starts_with(by_number) ? by_number.size() : 0);
  return is_name ? block.name == word : block.id > 0 && std::to_string(block.id) == number;
}

std::string shown(const std::string& name, GlobalIndex id) {
  if (name.empty()) return std::to_string(id);
  return id > 0 ? fmt::format("{} ({})", id, excerpt(name)) : excerpt(name);
}

/// Loads act once on a side that a file lists twice.
void keep_sides_once(Mesh& mesh) {
  for (auto& [name, sides] : mesh.side_sets) {
    std::set<Side> seen;
    std::erase_if(sides, [&](const Side& side) { return !seen.insert(side).second; });
  }
}

class Leaver {
 public:
  Leaver(const std::string& path, FileContent&& content) : path_(path), content_(std::move(content)) {
    drop_block_.resize(content_.mesh.blocks.size(), false);
    drop_foreign_.resize(content_.foreign.size(), false);
    for (std::size_t f = 0; f < content_.foreign.size(); ++f) drop_foreign_[f] = content_.foreign[f].passed;
  }

  Mesh leave(const std::vector<std::string>& ignore) {
    for (const std::string& word : ignore)
      if (!mark(word)) unknown(word);
    for (std::size_t f = 0; f < content_.foreign.size(); ++f)
      if (const ForeignBlock& block = content_.foreign[f]; !drop_foreign_[f] && !block.fault.empty())
        faults_.push_back(
            fmt::format("{}, or ignore: [{}] beside file to exclude the block", block.fault, excerpt(word_of(block))));
    if (!faults_.empty()) throw InputError(faults_);
    keep_sides_once(content_.mesh);
    drop_foreign_sets();
    drop_blocks();
    if (content_.mesh.blocks.empty() && !content_.mesh.left_out.empty())
      throw InputError(path_ + (ignore.empty()
                                    ? ": missing elements: no block of the file has solid elements or shells; "
                                      "expected at least one"
                                    : ": invalid ignore: it excludes every block; expected at least one "
                                      "block of solid elements or shells"));
    if (!ignore.empty()) drop_nodes();
    return std::move(content_.mesh);
  }

 private:
  [[nodiscard]] bool is_name(const std::string& word) const {
    const auto has_name = [&](const auto& block) { return block.name == word; };
    return std::ranges::any_of(content_.mesh.blocks, has_name) || std::ranges::any_of(content_.foreign, has_name);
  }

  /// What excludes the block.
  [[nodiscard]] std::string word_of(const ForeignBlock& block) const {
    const std::string word = name_or_number(block.name, block.id);
    return block.name.empty() && is_name(word) ? std::string(by_number) + word : word;
  }

  bool mark(const std::string& word) {
    const bool named = is_name(word);
    bool found = false;
    for (std::size_t b = 0; b < drop_block_.size(); ++b)
      if (is_called(content_.mesh.blocks[b], word, named)) found = drop_block_[b] = true;
    for (int dimension = 3; dimension >= 0; --dimension) {
      for (std::size_t f = 0; f < drop_foreign_.size(); ++f)
        if (content_.foreign[f].dimension == dimension && is_called(content_.foreign[f], word, named))
          found = drop_foreign_[f] = true;
      if (found) return true;
    }
    return false;
  }

  void unknown(const std::string& word) {
    std::string known;
    const auto add = [&](const auto& block) {
      const std::string name = shown(block.name, block.id);
      if (name != "0") known += (known.empty() ? "" : ", ") + name;
    };
    std::ranges::for_each(content_.mesh.blocks, add);
    std::ranges::for_each(content_.foreign, add);
    faults_.push_back(fmt::format("{}: unknown block '{}' in ignore; expected {}", path_, excerpt(word),
                                  known.empty() ? "none, since the file has no block" : known));
  }

  void drop_foreign_sets() {
    for (std::size_t f = 0; f < drop_foreign_.size(); ++f) {
      const ForeignBlock& block = content_.foreign[f];
      if (!drop_foreign_[f] || (block.count == 0 && !block.passed)) continue;
      const char* why = block.count == 0 ? "it has no elements"
                        : block.passed   ? "its elements are no solids"
                                         : by_ignore;
      content_.mesh.left_out.push_back({block.name, block.id, block.type, block.count, why});
      if (block.own_sets.empty()) continue;
      content_.mesh.side_sets.erase(block.own_sets);
      content_.mesh.node_sets.erase(block.own_sets);
    }
  }

  void drop_blocks() {
    Mesh& mesh = content_.mesh;
    std::vector<LocalIndex> place(mesh.blocks.size(), no_index);
    std::vector<Block> kept;
    for (std::size_t b = 0; b < mesh.blocks.size(); ++b) {
      Block& block = mesh.blocks[b];
      if (drop_block_[b]) {
        mesh.left_out.push_back(
            {block.name, block.id, std::string(cells::of(block.shape).name), block.count(), by_ignore});
      } else {
        place[b] = static_cast<LocalIndex>(kept.size());
        kept.push_back(std::move(block));
      }
    }
    const auto is_known = [&](const Side& side) {
      return side.block >= 0 && side.block < static_cast<LocalIndex>(place.size());
    };
    for (auto& [name, sides] : mesh.side_sets) {
      const auto gone = static_cast<std::size_t>(
          std::erase_if(sides, [&](const Side& side) { return is_known(side) && nth(drop_block_, side.block); }));
      for (Side& side : sides)
        if (is_known(side)) side.block = nth(place, side.block);
      const auto foreign = content_.foreign_sides.find(name);
      const std::size_t lost =
          gone + static_cast<std::size_t>(foreign == content_.foreign_sides.end() ? 0 : foreign->second);
      if (lost > 0)
        mesh.notes.push_back(fmt::format("side set {}: {} of its {} sides belong to excluded blocks", excerpt(name),
                                         lost, lost + sides.size()));
    }
    mesh.blocks = std::move(kept);
  }

  /// Positions beyond the mesh are faults that mesh::check tells.
  [[nodiscard]] bool indices_are_good() const {
    const Mesh& mesh = content_.mesh;
    const auto good = [&](LocalIndex n) { return n >= 0 && n < static_cast<LocalIndex>(mesh.coordinates.size()); };
    return std::ranges::all_of(mesh.blocks, [&](const Block& b) { return std::ranges::all_of(b.nodes, good); }) &&
           std::ranges::all_of(mesh.node_sets, [&](const auto& set) { return std::ranges::all_of(set.second, good); });
  }

  void drop_nodes() {
    Mesh& mesh = content_.mesh;
    if (!indices_are_good()) return;
    std::map<std::string, std::size_t> before;
    for (const auto& [name, nodes] : mesh.node_sets) before[name] = nodes.size();
    mesh::drop_unused_nodes(mesh);
    for (const auto& [name, nodes] : mesh.node_sets)
      if (nodes.size() < before[name])
        mesh.notes.push_back(fmt::format("node set {}: {} of its {} nodes belong to no remaining element",
                                         excerpt(name), before[name] - nodes.size(), before[name]));
  }

  const std::string& path_;
  FileContent content_;
  std::vector<bool> drop_block_, drop_foreign_;
  std::vector<std::string> faults_;
};

}  // namespace

std::string name_or_number(const std::string& name, GlobalIndex id) {
  return name.empty() ? std::to_string(id) : name;
}

mesh::Mesh leave_out(const std::string& path, FileContent&& content, const std::vector<std::string>& ignore) {
  return sound_mesh(path, Leaver(path, std::move(content)).leave(ignore));
}

}  // namespace brunt::io
