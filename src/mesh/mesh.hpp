// SPDX-License-Identifier: Apache-2.0
// A whole mesh as plain arrays, as read from a file or generated (it lives on the root rank only).
#pragma once
#include <array>
#include <compare>
#include <map>
#include <string>
#include <vector>

#include "core/cells.hpp"
#include "core/types.hpp"

namespace brunt::mesh {

using cells::Shape;
constexpr int nodes_per_element(Shape shape) {
  return cells::of(shape).corners;
}
constexpr int faces_per_element(Shape shape) {
  return static_cast<int>(cells::of(shape).faces.size());
}
/// Sides that a side set may contain: the faces; of a shell also its bottom, its one face seen from below.
constexpr int sides_per_element(Shape shape) {
  return cells::is_surface(shape) ? 2 : faces_per_element(shape);
}

struct Block {
  std::string name;    ///< empty where the file names none
  GlobalIndex id = 0;  ///< the file's block id, or the next free one where another mesh has it
  Shape shape = Shape::hex8;
  std::vector<LocalIndex> nodes;        ///< nodes_per_element a row
  std::vector<GlobalIndex> element_id;  ///< the input's number of each element, for messages
  GlobalIndex file_id = 0;              ///< its number in a mesh file; 0: of a generated body
  [[nodiscard]] LocalIndex count() const { return static_cast<LocalIndex>(nodes.size()) / nodes_per_element(shape); }
  [[nodiscard]] const LocalIndex* element(LocalIndex e) const {
    return nodes.data() + static_cast<std::size_t>(e) * static_cast<std::size_t>(nodes_per_element(shape));
  }
};

/// One side of one element; faces are numbered as in core/cells.hpp. Of a shell 0 is the top, 1 the bottom.
struct Side {
  LocalIndex block = 0, element = 0;
  std::int32_t face = 0;
  friend auto operator<=>(const Side&, const Side&) = default;
};

/// A block of a mesh file that is excluded.
struct LeftOut {
  std::string name;    ///< empty where the file names none
  GlobalIndex id = 0;  ///< the file's block number; 0: none
  std::string type;    ///< of its elements, as the file says it
  GlobalIndex count = 0;
  std::string why{};  ///< what excludes it, for messages
};

/// A mesh file among the meshes of a scene. Its node n has the number n + node_shift in the whole mesh.
struct FilePiece {
  std::string file, prefix;
  GlobalIndex node_shift = 0, first_node = 0, last_node = 0;  ///< numbers in the whole mesh
};

struct Mesh {
  std::vector<Vec3> coordinates;     ///< [length]
  std::vector<GlobalIndex> node_id;  ///< the input's number of each node, for messages
  std::vector<Block> blocks;
  std::map<std::string, std::vector<LocalIndex>> node_sets;  ///< by name, or by number in text where unnamed
  std::map<std::string, std::vector<Side>> side_sets;
  std::vector<LeftOut> left_out;
  std::vector<FilePiece> files;
  std::vector<std::string> notes;  ///< further notes for the user: sets that lost members with these blocks
};

}  // namespace brunt::mesh
