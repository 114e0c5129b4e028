// SPDX-License-Identifier: Apache-2.0
// All faces of a mesh in rows by their lowest node, so that equal faces are found among about a dozen: linear in the
// size of the mesh. Four bytes for each face and node are stored; the nodes of a face are read from its element when
// its row is visited.
#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "mesh/mesh.hpp"
#include "mesh/topology.hpp"

namespace brunt::mesh {

/// A face with at least three distinct nodes.
struct KeyedFace {
  std::array<LocalIndex, 4> key{};  ///< its nodes in ascending order, equal for all elements that share it; for a
                                    ///< triangle the first one is no_index
  LocalIndex element = 0;           ///< over all blocks in order
  std::int32_t face = 0;            ///< of the element, as in core/cells.hpp
  [[nodiscard]] bool same_nodes(const KeyedFace& other) const {
    return key[3] == other.key[3] && key[2] == other.key[2] && key[1] == other.key[1] && key[0] == other.key[0];
  }
};

class FaceRows {
 public:
  /// Keeps a reference to the mesh.
  explicit FaceRows(const Mesh& mesh);

  [[nodiscard]] std::size_t faces() const { return code_.size(); }

  /// Calls visit(std::span<const KeyedFace>) for the faces whose lowest node is the same, in ascending order of these
  /// nodes; within a row the faces ascend by element and face.
  template <class Visit>
  void for_each_row(Visit&& visit) const {
    std::vector<KeyedFace> row;
    for (std::size_t node = 0; node + 1 < first_.size(); ++node) {
      if (first_[node] == first_[node + 1]) continue;
      row.clear();
      for (std::uint32_t i = first_[node]; i < first_[node + 1]; ++i) row.push_back(face_of(code_[i]));
      visit(std::span<const KeyedFace>(row));
    }
  }

  /// The side of a visited face.
  [[nodiscard]] Side side(const KeyedFace& face) const {
    const std::size_t block = block_of(face.element);
    return {static_cast<LocalIndex>(block), face.element - block_first_[block], face.face};
  }

 private:
  [[nodiscard]] std::size_t block_of(LocalIndex element) const;
  [[nodiscard]] KeyedFace face_of(std::uint32_t code) const;

  const Mesh& mesh_;
  std::vector<LocalIndex> block_first_;  // element of each block's first; the last entry counts all
  std::vector<std::uint32_t> first_;     // of each node's row; the last entry counts all faces
  std::vector<std::uint32_t> code_;      // key of the face, see core/cells.hpp
};

}  // namespace brunt::mesh
