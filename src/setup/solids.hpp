// SPDX-License-Identifier: Apache-2.0
// The blocks of a whole mesh as solids, and the positions of the surface nodes of one relative to another. Pure
// geometry.
#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "contact/data/standard_tolerances.hpp"
#include "core/ragged.hpp"
#include "core/types.hpp"
#include "geometry/box.hpp"
#include "geometry/closest_point.hpp"
#include "mesh/mesh.hpp"

namespace brunt::setup {

/// Three or four nodes of an exterior face, no_index after a triangle's.
using FaceNodes = std::array<LocalIndex, 4>;

struct SolidFace {
  FaceNodes nodes{};
  std::array<Vec3, 4> corners;
  std::size_t corner_count = 0;
  LocalIndex element = no_index;  ///< of the block, behind the face
  double size = 0;                ///< longest edge [length]
  double element_depth = 0;       ///< of that element, or the width of the face if that is less [length]
  [[nodiscard]] geometry::Corners points() const { return {corners.data(), corner_count}; }
};

/// One block: its exterior faces, except those without three distinct nodes.
struct Solid {
  std::vector<SolidFace> faces;
  std::vector<LocalIndex> surface_nodes;         ///< ascending
  Ragged<Vec3> outwards;                         ///< for each of them: unit normals of its faces
  std::vector<std::array<LocalIndex, 2>> edges;  ///< of its faces, lower node first, ascending, each once
  geometry::Box box;
};

std::vector<Solid> solids_of(const mesh::Mesh& mesh);

/// The bounding box of the element's nodes.
geometry::Box box_of_element(const mesh::Mesh& mesh, const mesh::Block& block, LocalIndex element);

/// Whether x lies in the closed element. A hexahedron is treated as six tetrahedra around its diagonal 0-6.
bool in_element(const Vec3& x, const mesh::Mesh& mesh, const mesh::Block& block, LocalIndex element,
                const contact::Tolerances& tolerances);

/// The connected body of each node; no_index for a node without elements.
std::vector<std::int32_t> body_of_nodes(const mesh::Mesh& mesh);

/// The face in front of a node inside a solid.
struct Behind {
  std::size_t face = 0;
  double penetration = 0;  ///< along the normal [length]; < 0: the node is in front of a warped face
  Vec3 normal = Vec3::Zero();
  std::array<double, 4> weights{};  ///< of the face's corners at the nearest point
};

/// The elements of each node.
class NodesAround {
 public:
  explicit NodesAround(const mesh::Mesh& mesh);
  /// The nodes of all elements of a node, ascending.
  [[nodiscard]] std::vector<LocalIndex> of(LocalIndex node) const;

 private:
  struct Use {
    LocalIndex node, block, element;
    friend auto operator<=>(const Use&, const Use&) = default;
  };
  const mesh::Mesh& mesh_;
  std::vector<Use> uses_;  // ascending
};

/// The surface nodes of one block that are near the solid of another block, or inside it.
class Comparison {
 public:
  /// around: given if the two blocks are the same, or connected. Then only nodes inside are considered, and elements
  /// that touch an element of the node do not count (as in contact): the node is neither inside them nor behind their
  /// faces.
  Comparison(const mesh::Mesh& mesh, const Solid& nodes, const Solid& solid, const mesh::Block& block,
             const NodesAround* around, const contact::Tolerances& tolerances = contact::standard_tolerances);

  [[nodiscard]] std::size_t size() const { return node_.size(); }
  [[nodiscard]] LocalIndex node(std::size_t i) const { return nodes_.surface_nodes[node_[i]]; }
  /// Whether the node lies at a face, and not deep behind another face that its surface opposes (such as the rim of a
  /// flush body that overlaps).
  [[nodiscard]] bool touches(std::size_t i) const { return touches_[i] != Touch::none; }
  [[nodiscard]] bool overlaps(std::size_t i) const { return inside_[i] != 0 && touches_[i] == Touch::none; }
  /// Distance to the nearest face within its longest edge, else infinite.
  [[nodiscard]] double distance(std::size_t i) const { return near_[i]; }
  /// For an overlapping node: the nearest face that the node's own surface opposes, even if a face beside it is nearer.
  /// A node beyond the middle of a plate is thus behind the face through which it came. `near` considers only faces
  /// within their longest edge and returns nothing if none of them is opposed; `any` considers all faces, and returns
  /// the nearest one if none is opposed.
  [[nodiscard]] std::optional<Behind> behind_near(std::size_t i) const;
  [[nodiscard]] std::optional<Behind> behind_any(std::size_t i) const;

 private:
  enum class Touch : std::int8_t {
    none,
    side,
    face
  };  ///< of a face that the node's own surface opposes, or only others
  /// Nearest of all faces, and of those opposed.
  struct Nearest {
    std::optional<Behind> all, opposed;
    double all_distance = 0, opposed_distance = 0;
    /// Tetrahedra do not represent a warped face exactly: if the nearest face has the node in front, it decides (except
    /// where they touch).
    [[nodiscard]] const std::optional<Behind>& chosen(const Solid& solid, double touching) const {
      return all && all->penetration < -touching * solid.faces[all->face].size ? all : opposed;
    }
  };
  void judge(std::size_t i, std::size_t face, Nearest& nearest) const;
  [[nodiscard]] Nearest nearest_near(std::size_t i) const;
  [[nodiscard]] bool is_deep(std::size_t i) const;
  [[nodiscard]] bool is_opposed(std::size_t i, const Vec3& normal) const;
  [[nodiscard]] bool is_neighbour(std::size_t i, LocalIndex element) const;
  void keep_inside_only();
  void measure_near();
  void find_inside(const mesh::Mesh& mesh);

  const Solid &nodes_, &solid_;
  const mesh::Block& block_;
  const NodesAround* around_;
  const contact::Tolerances& tolerances_;
  std::vector<std::size_t> node_;  // into nodes_.surface_nodes
  std::vector<Vec3> point_;
  Ragged<LocalIndex> near_faces_;  // within their longest edge, or a little more
  std::vector<double> near_;
  std::vector<Touch> touches_;
  std::vector<char> inside_;
};

}  // namespace brunt::setup
