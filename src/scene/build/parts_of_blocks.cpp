// SPDX-License-Identifier: Apache-2.0
// Assigns the parts to the blocks of the mesh.
#include <fmt/core.h>

#include <algorithm>

#include "core/error.hpp"
#include "core/excerpt.hpp"
#include "scene/build/rigid_parts.hpp"
#include "scene/build/select.hpp"
#include "scene/text/nearest.hpp"

namespace brunt::scene {
namespace {

constexpr std::size_t none = static_cast<std::size_t>(-1);

const char* fitting_elements(mesh::Shape shape) {
  return shape == mesh::Shape::hex8 ? "hex8, hex8_full or hex8_bbar" : "tet4";
}

/// Why a mesh file's block of this name or number is excluded; empty if there is none.
std::string why_left_out(const mesh::Mesh& mesh, const std::string& word) {
  const auto found = std::ranges::find_if(mesh.left_out, [&](const mesh::LeftOut& block) {
    return block.name == word || (block.id > 0 && std::to_string(block.id) == word);
  });
  return found == mesh.left_out.end() ? "" : found->why;
}

constexpr std::string_view by_number = "number_";

std::vector<std::size_t> blocks_numbered(const mesh::Mesh& mesh, std::string_view number) {
  std::vector<std::size_t> found;
  for (std::size_t b = 0; b < mesh.blocks.size(); ++b) {
    const mesh::Block& block = mesh.blocks[b];
    if (std::to_string(block.id) == number || (block.file_id > 0 && std::to_string(block.file_id) == number))
      found.push_back(b);
  }
  return found;
}

/// The blocks of this name; if there is none, those of this number in the whole mesh or in their file. number_7 is
/// number 7 also where another block has the name 7.
std::vector<std::size_t> blocks_called(const mesh::Mesh& mesh, std::string_view word) {
  std::vector<std::size_t> named;
  for (std::size_t b = 0; b < mesh.blocks.size(); ++b)
    if (mesh.blocks[b].name == word) named.push_back(b);
  if (!named.empty()) return named;
  return blocks_numbered(mesh, word.starts_with(by_number) ? word.substr(by_number.size()) : word);
}

/// The block's number, or number_7 where another block has the name 7.
std::string number_word(const mesh::Mesh& mesh, std::size_t b) {
  const std::string number = std::to_string(mesh.blocks[b].id);
  const bool is_other_name = std::ranges::any_of(
      mesh.blocks, [&](const mesh::Block& other) { return &other != &mesh.blocks[b] && other.name == number; });
  return is_other_name ? std::string(by_number) + number : number;
}

/// "7" or "7 (bar)": a scene may use either.
std::string shown(const mesh::Mesh& mesh, std::size_t b) {
  const std::string& name = mesh.blocks[b].name;
  return number_word(mesh, b) + (name.empty() ? "" : " (" + excerpt(name) + ")");
}

std::string shown_blocks(const mesh::Mesh& mesh) {
  std::vector<std::string> known;
  for (std::size_t b = 0; b < mesh.blocks.size(); ++b) known.push_back(shown(mesh, b));
  return known.empty() ? "(the mesh has no block)" : listed(known);
}

std::string ambiguous(const mesh::Mesh& mesh, const std::vector<std::size_t>& blocks, const std::string& word) {
  std::vector<std::string> known;
  for (const std::size_t b : blocks) known.push_back(shown(mesh, b));
  const bool by_name = mesh.blocks[blocks.front()].name == word;
  return fmt::format("invalid block '{}': several blocks of the mesh have this {}: {}; expected the {} of one",
                     excerpt(word), by_name ? "name" : "number", listed(known), by_name ? "number" : "name");
}

}  // namespace

std::vector<std::size_t> parts_of_blocks(const Input& input, const mesh::Mesh& mesh) {
  std::vector<std::string> faults;
  std::vector<std::size_t> part_of(mesh.blocks.size(), none);
  std::vector<char> doubtful(mesh.blocks.size(), 0);  // perhaps meant by a number: no fault of its own
  for (std::size_t p = 0; p < input.parts.size(); ++p) {
    const Part& part = input.parts[p];
    const std::string key = "parts." + part.name;
    const std::vector<std::size_t> found = blocks_called(mesh, part.block);
    if (found.size() > 1) {
      faults.push_back(input.at(key + ".block") + ": " + ambiguous(mesh, found, part.block));
      for (const std::size_t b : found) doubtful[b] = 1;
      continue;
    }
    if (found.empty()) {
      if (const std::string why = why_left_out(mesh, part.block); !why.empty()) {
        faults.push_back(fmt::format("{}: invalid block '{}': {}; expected one of {}", input.at(key + ".block"),
                                     excerpt(part.block), why, shown_blocks(mesh)));
        continue;
      }
      faults.push_back(fmt::format("{}: unknown block '{}' of the mesh; expected one of {}", input.at(key + ".block"),
                                   excerpt(part.block), shown_blocks(mesh)));
      continue;
    }
    const std::size_t b = found.front();
    if (part_of[b] != none)
      faults.push_back(fmt::format(
          "{}: invalid block {}: it already belongs to part '{}'; expected a block of its own for each part",
          input.at(key + ".block"), excerpt(part.block), excerpt(input.parts[part_of[b]].name)));
    part_of[b] = p;
    if (!is_rigid(input, part) && (part.element == ElementKind::tet4) != (mesh.blocks[b].shape == mesh::Shape::tet4))
      faults.push_back(fmt::format("{}: invalid element {} for the shape of the block's elements; expected {}",
                                   input.at(key + ".element"), element::name_of(part.element),
                                   fitting_elements(mesh.blocks[b].shape)));
  }
  for (std::size_t b = 0; b < mesh.blocks.size(); ++b)
    if (part_of[b] == none && doubtful[b] == 0)
      faults.push_back(
          fmt::format("{}: missing part for block {} of the mesh; expected NAME: {{block: {}, material: ...}} in "
                      "parts, or ignore: [{}] in the entry of the mesh file",
                      input.at("parts"), shown(mesh, b), number_word(mesh, b),
                      mesh.blocks[b].name.empty() ? number_word(mesh, b) : excerpt(mesh.blocks[b].name)));
  if (!faults.empty()) throw InputError(std::move(faults));
  return part_of;
}

}  // namespace brunt::scene
