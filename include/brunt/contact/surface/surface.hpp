// SPDX-License-Identifier: Apache-2.0
// The faces and nodes that may touch, and which of two bodies is the slave.
#pragma once
#include <array>
#include <span>
#include <utility>
#include <vector>

#include "brunt/contact/data/row_key.hpp"
#include "brunt/contact/data/specification.hpp"
#include "brunt/core/ragged.hpp"
#include "brunt/core/types.hpp"
#include "brunt/mesh/local_mesh.hpp"

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
  double element_depth = 0;  ///< of its element behind it, or its width if less, at the start [length]
  std::uint8_t seams = 0;    ///< bit i: beyond side i (corners i, i + 1) another face goes on, see seams.hpp
  std::array<GlobalIndex, 8> element{};  ///< nodes of that element, no_index to fill; the corners without an element
};

/// By the angle between the faces of an edge at the start. Convex edges that are sharp meet any of other bodies, blunt
/// ones those that are sharp (a facet's edge on a round body slips between the nodes of a rim), and so do flat ones,
/// which lie within a face of the body: a rim that crosses it has no node near it where its mesh is coarse.
enum class EdgeKind : std::int8_t { flat, blunt, sharp };

/// An edge of the reference surface that may meet others as an edge.
struct SurfaceEdge {
  std::array<LocalIndex, 2> nodes{};       ///< surface nodes, lower gid first
  std::array<Place, 2> facets{};           ///< the two faces that meet in it, lower key first
  std::array<GlobalIndex, 16> elements{};  ///< nodes of the elements behind them, no_index to fill
  std::int32_t body = 0, block = 0;        ///< of the first
  double element_depth = 0;                ///< the smaller one of the two faces [length]
  EdgeKind kind = EdgeKind::sharp;
  std::array<bool, 2> seam{};  ///< of each of its two faces: does another one go on beyond it? See seams.hpp
  /// Of each end, of each face: does the edge end below a seam of which the face is the side?
  std::array<std::array<bool, 2>, 2> end_at_side{};
};

/// What decides who is slave; the same on every rank.
struct BodyFigures {
  double mean_area = 0;                ///< of its contact faces [length^2]
  double mean_mass = 0;                ///< of its surface nodes [mass]; infinite where one cannot move at all
  std::vector<std::int32_t> blocks{};  ///< of its contact faces, ascending
};

/// A node as far as it decides what it may meet, and how.
struct SurfaceNode {
  std::span<const std::int32_t> blocks{};  ///< of its contact faces
  std::int32_t body = 0;
  bool on_rim = false;  ///< stands on a sharp edge
};

/// One rank's part of the surface of all bodies. Nodes: those of this rank's mesh that lie on any exterior face of the
/// whole model, in ascending gid.
struct Surface {
  std::vector<GlobalIndex> gid;
  std::vector<LocalIndex> model_node;  ///< local node of the mesh
  std::vector<Place> home;             ///< surface node on the owner
  std::vector<std::int32_t> body;      ///< known for nodes owned here, else no_index
  Ragged<std::int32_t> blocks;         ///< for nodes owned here: blocks of their contact faces, ascending
  std::vector<char> on_rim;            ///< do they stand on a sharp edge?
  Ragged<Place> facets;                ///< for nodes owned here: their contact faces by key
  std::vector<double> seam_sag;     ///< of each of facets.values: sag of a seam that ends in the node, or 0 [length];
                                    ///< empty: there is no seam
  Ragged<GlobalIndex> neighbours;   ///< for nodes owned here: nodes of the elements that contain them, ascending
  std::vector<SurfaceFace> faces;   ///< contact faces of this rank's elements, by key
  std::vector<SurfaceEdge> edges;   ///< convex ones between faces of which this rank has the one with the lower key
  std::vector<BodyFigures> bodies;  ///< of the whole model
  std::vector<BodyPair> flush;      ///< of the whole model: bodies between which there is a seam, ascending
  double mean_edge = 0;             ///< mean over all contact faces of their longest edge [length]
  double mean_element_depth =
      0;  ///< mean over the same of the element depth, or the longest edge if that is less [length]

  [[nodiscard]] SurfaceNode node(LocalIndex owned) const {
    return {blocks.row(owned), body[static_cast<std::size_t>(owned)], on_rim[static_cast<std::size_t>(owned)] != 0};
  }
  [[nodiscard]] bool owns(LocalIndex node, Rank rank) const {
    return home[static_cast<std::size_t>(node)].rank == rank;
  }
};

/// Is body a the slave where it meets body b? The finer (smaller mean face area) is; where these agree within
/// Tolerances::equal_figures, the lighter; else the lower number. (One exact pass with the finer, lighter side as slave
/// converges fastest and leaves the least error on the other side.)
bool is_slave(std::span<const BodyFigures> bodies, std::int32_t a, std::int32_t b,
              const Tolerances& tolerances = standard_tolerances);

/// Are their meshes equal where they meet, neither side much finer or lighter? See Passes::automatic.
bool have_similar_meshes(const BodyFigures& one, const BodyFigures& other,
                         const Tolerances& tolerances = standard_tolerances);

/// Do a node and a face of this block and body meet in two passes? In one automatic pass nodes on rims do as well: a
/// rim sags beyond the last node of the slave that holds it, and those that come under it later would be deep in the
/// master when they are first seen.
bool meet_in_two_passes(const Specification& specification, std::span<const BodyFigures> bodies,
                        const SurfaceNode& node, std::int32_t face_block, std::int32_t face_body);

/// Does any pair of bodies?
bool any_two_passes(const Specification& specification, std::span<const BodyFigures> bodies);

/// Which bodies can be slave, or master, of another or of themselves: the rest need not be searched as such.
struct Roles {
  std::vector<char> slave, master;
  std::vector<char> slave_rims;  ///< bodies of which the nodes on rims alone can be slaves
};
Roles roles_of(std::span<const BodyFigures> bodies, const Specification& specification);

/// Is a node the slave of a face of this block and body, were there one pass? Within one body every node is: which of
/// two folds would be the finer side is not known before they meet.
bool is_primary_slave(const Specification& specification, std::span<const BodyFigures> bodies, const SurfaceNode& node,
                      std::int32_t face_block, std::int32_t face_body);

/// May a node be held off by a face of this block and body? Those that lead, and in two passes the other side's too.
bool may_meet(const Specification& specification, std::span<const BodyFigures> bodies, const SurfaceNode& node,
              std::int32_t face_block, std::int32_t face_body);

}  // namespace brunt::contact
