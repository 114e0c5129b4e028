// SPDX-License-Identifier: Apache-2.0
// The faces and nodes that may have contact, and the choice of the slave of two bodies.
#pragma once
#include <array>
#include <limits>
#include <span>
#include <utility>
#include <vector>

#include "contact/data/row_key.hpp"
#include "contact/data/specification.hpp"
#include "core/cells.hpp"
#include "core/ragged.hpp"
#include "core/types.hpp"
#include "mesh/local_mesh.hpp"

namespace brunt::contact {

/// An entry of an array on some rank: a surface node on its owner, a face on the rank of its element.
struct Place {
  Rank rank = 0;
  LocalIndex index = 0;
  friend auto operator<=>(const Place&, const Place&) = default;
};

struct SurfaceFace {
  GlobalIndex key = 0;
  std::array<LocalIndex, 4> nodes{};  ///< surface nodes, counter-clockwise seen from outside
  std::int32_t corner_count = 4;
  std::int32_t body = 0, block = 0;
  double element_depth = 0;  ///< of the element behind it, or its width if that is less, at the start [length]
  std::uint8_t seams = 0;    ///< bit i: another face continues beyond side i (corners i, i + 1), see seams.hpp
  /// Nodes of that element, no_index to fill; the corners without an element.
  std::array<GlobalIndex, cells::most_corners> element{};
};

/// Kind of an edge by the initial angle between its faces. Sharp convex edges have contact with all edges of other
/// bodies; blunt and flat ones with sharp edges only. Blunt edges are needed because a facet's edge on a round body
/// passes between the nodes of a rim; flat ones, which lie within a face of the body, because a rim that crosses them
/// may have no node near where its mesh is coarse.
enum class EdgeKind : std::int8_t { flat, blunt, sharp };

/// An edge of the reference surface that may have edge-to-edge contact.
struct SurfaceEdge {
  std::array<LocalIndex, 2> nodes{};                            ///< surface nodes, lower gid first
  std::array<Place, 2> facets{};                                ///< the two faces that meet in it, lower key first
  std::array<GlobalIndex, 2 * cells::most_corners> elements{};  ///< nodes of the elements behind them, no_index to fill
  std::int32_t body = 0, block = 0;                             ///< of the first
  double element_depth = 0;                                     ///< the smaller one of the two faces [length]
  EdgeKind kind = EdgeKind::sharp;
  std::array<bool, 2> seam{};  ///< for each of its two faces: whether another one continues beyond it, see seams.hpp
  /// For each end and each face: whether the edge ends below a seam whose side is the face.
  std::array<std::array<bool, 2>, 2> end_at_side{};
};

/// Quantities that determine the slave; equal on every rank.
struct BodyFigures {
  double mean_area = 0;                ///< of its contact faces [length^2]
  double mean_mass = 0;                ///< of its surface nodes [mass]; infinite if one of them is immovable
  std::vector<std::int32_t> blocks{};  ///< of its contact faces, ascending
  double longest_edge = 0;             ///< of its contact faces [length]
  double shortest_edge = std::numeric_limits<double>::infinity();  ///< likewise
};

/// The properties of a node that determine its admissible contacts.
struct SurfaceNode {
  std::span<const std::int32_t> blocks{};  ///< of its contact faces
  std::int32_t body = 0;
  bool on_rim = false;  ///< lies on a sharp edge
};

/// One rank's part of the surface of all bodies. Nodes: those of this rank's mesh on any exterior face of the whole
/// model, in ascending gid.
struct Surface {
  std::vector<GlobalIndex> gid;
  std::vector<LocalIndex> model_node;  ///< local node of the mesh
  std::vector<Place> home;             ///< surface node on the owner
  std::vector<std::int32_t> body;      ///< known for nodes owned here, else no_index
  Ragged<std::int32_t> blocks;         ///< for nodes owned here: blocks of their contact faces, ascending
  std::vector<char> on_rim;            ///< whether they lie on a sharp edge
  Ragged<Place> facets;                ///< for nodes owned here: their contact faces by key
  std::vector<double> seam_sag;        ///< of each of facets.values: settlement of a seam that ends in the node, or 0
                                       ///< [length]; empty: there is no seam
  Ragged<GlobalIndex> neighbours;      ///< for nodes owned here: nodes of the elements that contain them, ascending
  std::vector<SurfaceFace> faces;      ///< contact faces of this rank's elements, by key
  std::vector<SurfaceEdge> edges;      ///< convex ones between faces, on the rank of the face with the lower key
  std::vector<BodyFigures> bodies;     ///< of the whole model
  std::vector<BodyPair> flush;         ///< of the whole model: bodies between which there is a seam, ascending
  double mean_edge = 0;                ///< mean over all contact faces of their longest edge [length]
  double mean_element_depth =
      0;  ///< mean over the same of the element depth, or the longest edge if that is less [length]

  [[nodiscard]] SurfaceNode node(LocalIndex owned) const {
    return {blocks.row(owned), nth(body, owned), nth(on_rim, owned) != 0};
  }
  [[nodiscard]] bool owns(LocalIndex node, Rank rank) const { return nth(home, node).rank == rank; }
};

/// Whether body a is the slave in contact with body b. The finer one (smaller mean face area) is the slave; if these
/// agree within Tolerances::equal_figures, the lighter one; otherwise that with the lower number. (One exact pass with
/// the finer, lighter side as slave converges fastest and leaves the smallest error on the other side.)
bool is_slave(std::span<const BodyFigures> bodies, std::int32_t a, std::int32_t b,
              const Tolerances& tolerances = standard_tolerances);

/// Whether the meshes are similar, neither side much finer or lighter. See Passes::automatic.
bool have_similar_meshes(const BodyFigures& one, const BodyFigures& other,
                         const Tolerances& tolerances = standard_tolerances);

/// Whether the nodes of `slave` are nowhere and in no direction farther apart than those of `master`. Means over a body
/// do not show this: a bar of long elements may have small faces, and a graded plate coarse ones at its rim.
bool is_finer_everywhere(const BodyFigures& slave, const BodyFigures& master,
                         const Tolerances& tolerances = standard_tolerances);

/// Whether a node and a face of this block and body have two-pass contact. In automatic one-pass contact this also
/// applies to nodes on rims: a rim bends beyond the last slave node that supports it, and slave nodes that slide below
/// it later would be deep inside the master when they are first detected.
bool meet_in_two_passes(const Specification& specification, std::span<const BodyFigures> bodies,
                        const SurfaceNode& node, std::int32_t face_block, std::int32_t face_body);

/// Whether any pair of bodies has two-pass contact.
bool any_two_passes(const Specification& specification, std::span<const BodyFigures> bodies);

/// The bodies that can be slave, or master, of another one or of themselves; the others need no search in this role.
struct Roles {
  std::vector<char> slave, master;
  std::vector<char> slave_rims;  ///< bodies of which only the nodes on rims can be slaves
};
Roles roles_of(std::span<const BodyFigures> bodies, const Specification& specification);

/// Whether a node is the slave of a face of this block and body in one-pass contact. Within one body every node is:
/// which of two folds will be the finer side is not known before they touch.
bool is_primary_slave(const Specification& specification, std::span<const BodyFigures> bodies, const SurfaceNode& node,
                      std::int32_t face_block, std::int32_t face_body);

/// Whether a node may be constrained by a face of this block and body: primary slaves, and in two passes also nodes of
/// the other side.
bool may_meet(const Specification& specification, std::span<const BodyFigures> bodies, const SurfaceNode& node,
              std::int32_t face_block, std::int32_t face_body);

}  // namespace brunt::contact
