// SPDX-License-Identifier: Apache-2.0
// How deep bodies really are in each other, from the positions of nodes in elements alone: what contact reports is to
// be no more, and no less. Nothing of geometry/ is used, by which contact finds what is checked here.
#pragma once
#include <functional>
#include <utility>
#include <vector>

#include "mesh/mesh.hpp"

namespace brunt::test {

/// Where a point lies in a body.
struct Depth {
  double depth = 0;       ///< distance to the nearest exterior face; 0 outside of all elements [length]
  double edge = 1;        ///< mean edge of that face [length]
  double in_face = 0;     ///< least of the area coordinates (quad: 1 - |xi|, 1 - |eta|) there: 0 on its border
  std::size_t face = 0;   ///< position of that face among the exterior faces of the block
  Vec3 nearest{0, 0, 0};  ///< the point on it
};

/// The elements of one block, at the positions that `move` sets.
class Solid {
 public:
  Solid(const mesh::Mesh& mesh, LocalIndex block);

  /// position: of a node of the mesh. Depths are of these positions until the next call.
  void move(const std::function<Vec3(LocalIndex)>& position);

  /// Of a point in the elements: of a hexahedron by the inverse of its trilinear map, of a tetrahedron by barycentric
  /// coordinates.
  [[nodiscard]] Depth depth(const Vec3& point) const;

  [[nodiscard]] const std::vector<LocalIndex>& nodes() const { return nodes_; }  ///< of exterior faces, ascending
  [[nodiscard]] const std::vector<std::pair<LocalIndex, LocalIndex>>& edges() const { return edges_; }
  [[nodiscard]] const Vec3& position(LocalIndex node) const { return position_[static_cast<std::size_t>(node)]; }

 private:
  struct Box {
    Vec3 low = Vec3::Zero(), high = Vec3::Zero();
    [[nodiscard]] bool holds(const Vec3& point) const {
      return (point.array() >= low.array()).all() && (point.array() <= high.array()).all();
    }
    [[nodiscard]] double distance(const Vec3& point) const {
      return (low - point).cwiseMax(point - high).cwiseMax(Vec3::Zero()).norm();
    }
  };
  struct Cell {
    std::vector<LocalIndex> nodes;
    Box box{};
  };

  [[nodiscard]] Box box_of(const std::vector<LocalIndex>& nodes) const;
  [[nodiscard]] bool holds(const Cell& element, const Vec3& point) const;

  std::vector<Cell> elements_, faces_;
  std::vector<LocalIndex> nodes_;
  std::vector<std::pair<LocalIndex, LocalIndex>> edges_;
  std::vector<Vec3> position_;  ///< by node of the mesh
  Box whole_{};
};

/// The deepest node of `one` in `other`.
Depth deepest_node(const Solid& one, const Solid& other);
/// The deepest of the points that divide the edges of `one` in twelve.
Depth deepest_on_edges(const Solid& one, const Solid& other);

}  // namespace brunt::test
