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
  switch (shape) {
    case mesh::Shape::hex8:
      return "hex8, hex8_full or hex8_bbar";
    case mesh::Shape::tet4:
      return "tet4";
    case mesh::Shape::quad4:
      return "shell4 or shell4_full";
    case mesh::Shape::tri3:
      return "shell3";
  }
  return "";
}

mesh::Shape shape_of(ElementKind kind) {
  switch (kind) {
    case ElementKind::tet4:
      return mesh::Shape::tet4;
    case ElementKind::shell4:
    case ElementKind::shell4_full:
      return mesh::Shape::quad4;
    case ElementKind::shell3:
      return mesh::Shape::tri3;
    default:
      return mesh::Shape::hex8;
  }
}

/// A key that only one-point quadrilaterals have, given to shells of another kind; empty if there is none.
std::string idle_key(const Input& input, const Part& part, ElementKind kind) {
  const Hourglass usual;
  const bool controls = part.hourglass.kind != usual.kind || part.hourglass.coefficient != usual.coefficient;
  if (part.section.warping && !controls) return "";
  const char* idle = controls ? "hourglass" : "warping";
  return fmt::format("{}: invalid {}: {} has nothing that it controls; expected element: shell4, or no {}",
                     input.at(fmt::format("parts.{}.{}", part.name, idle)), idle, element::name_of(kind), idle);
}

/// Whether the element of a part, and its thickness, fit the shape of the block; empty if they do.
std::string fault_of_shape(const Input& input, const Part& part, mesh::Shape shape) {
  const std::string key = "parts." + part.name;
  const ElementKind kind = kind_of(part, shape);
  if (!is_rigid(input, part) && shape_of(kind) != shape)
    return fmt::format("{}: invalid element {} for the shape of the block's elements; expected {}",
                       input.at(key + ".element"), element::name_of(kind), fitting_elements(shape));
  if (cells::is_surface(shape) && part.section.thickness == 0)
    return fmt::format("{}: missing thickness: the block has shells; expected thickness: a length > 0", input.at(key));
  if (!cells::is_surface(shape) && part.section.thickness > 0)
    return fmt::format("{}: invalid thickness: the elements of the block are solid; expected no thickness",
                       input.at(key + ".thickness"));
  return cells::is_surface(shape) && kind != ElementKind::shell4 ? idle_key(input, part, kind) : "";
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

ElementKind kind_of(const Part& part, mesh::Shape shape) {
  if (part.element) return *part.element;
  if (shape == mesh::Shape::quad4) return ElementKind::shell4;
  return shape == mesh::Shape::tri3 ? ElementKind::shell3 : ElementKind::hex8;
}

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
    if (std::string fault = fault_of_shape(input, part, mesh.blocks[b].shape); !fault.empty())
      faults.push_back(std::move(fault));
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
