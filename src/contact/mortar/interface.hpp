// SPDX-License-Identifier: Apache-2.0
// One mortar interface: its two surfaces, its rows at a configuration, and their derivatives. It does not depend on
// ranks: a rank with all facets around a slave node and their candidates has the complete row of the node.
//
// Sign convention: the normal of a row points out of the master (minus the slave's nodal normal), gap > 0 is open, a
// multiplier z >= 0 is a pressure. Row A has the weights w_AK = + int psi_A N_B at slave nodes and
// - int psi_A N_C at master nodes, of sum zero, so
//   vector gap G_A = sum_K w_AK x_K,  gap = normal_A . G_A,  force of a traction T_A on node K: w_AK T_A,
// with T_A = z_A normal_A without friction.
#pragma once
#include <algorithm>
#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "contact/mortar/weights.hpp"
#include "core/ragged.hpp"
#include "core/types.hpp"

namespace brunt::contact {

/// Nodes of a facet; a triangle's fourth is no_index.
using FacetNodes = std::array<LocalIndex, 4>;

/// Smooth patches of facets around nodes (patches.hpp).
struct NodePatches {
  std::vector<FacetNodes> of_corner;  ///< for each facet: the patches of its corners; no_index: no corner
  std::vector<std::uint8_t> rims;     ///< for each facet: sides at which the surface ends, bit k from corner k
  Ragged<LocalIndex> facets;          ///< of each patch, ascending
  std::vector<std::uint8_t> at_rim;   ///< whether the node of each patch is the end of such a side
};

/// One facet of them, on any rank.
struct PatchNumbers {
  std::array<GlobalIndex, 4> of_corner{};  ///< which need not be consecutive; -1: no corner
  std::int64_t rims = 0;                   ///< as NodePatches::rims
};

struct MortarSurfaces {
  std::vector<FacetNodes> slave;   ///< in the order of their keys; those without candidates contribute to normals only
  std::vector<FacetNodes> master;  ///< nodes number one array, common to both sides
  std::vector<LocalIndex> rows;    ///< the slave node of each row
  /// For each slave facet: the rows of its corners, those of other ranks from rows.size() on; no_index: none. Empty:
  /// each node has one row at most.
  std::vector<FacetNodes> corner_rows{};
  Ragged<Vec3> mirrors;  ///< for each row: unit normals of the symmetry planes that contain its node; or no rows
  Multiplier multiplier = Multiplier::dual;
  /// For each slave facet: whether its multipliers are standard ones all the same; empty: none.
  std::vector<std::uint8_t> at_edge{};
  double capture = 0;   ///< greatest distance of two facets along the normal [length]
  bool fading = false;  ///< pairs come in with a share that has no jump (fading.hpp)
  /// For each facet: thickness of its own body behind it [length]; empty if all bodies are thicker than `capture`.
  std::vector<double> slave_wall{}, master_wall{};
  NodePatches master_patches{};  ///< for rows of points; otherwise empty
  /// On distributed surfaces: slave nodes with rows on other ranks; their tractions follow those of the rows.
  std::vector<LocalIndex> rows_elsewhere{};
  /// For each slave facet: whether its segments are counted and its patch is formed here; empty: for all.
  std::vector<std::uint8_t> ours{};

  [[nodiscard]] Multiplier multiplier_of(std::size_t slave_facet) const {
    return at_edge.empty() || at_edge[slave_facet] == 0 ? multiplier : Multiplier::standard;
  }
  [[nodiscard]] bool is_ours(std::size_t slave_facet) const { return ours.empty() || ours[slave_facet] != 0; }
  /// Largest admissible penetration of the facets of a pair [length]: a deeper facet is on the far side of a wall.
  [[nodiscard]] double deepest(std::size_t slave_facet, std::size_t master_facet) const {
    constexpr double of_wall = 0.8;   // below 1: a loaded wall is thinner than in the reference configuration
    double wall = of_wall * capture;  // thicker walls are not seen
    if (!slave_wall.empty()) wall = std::min(wall, of_wall * slave_wall[slave_facet]);
    if (!master_wall.empty()) wall = std::min(wall, of_wall * master_wall[master_facet]);
    return wall;
  }
};

/// Data that depend only on the surfaces and the reference configuration.
struct MortarTopology {
  /// For each slave facet: the rows of its corners, from the number of rows on those of other ranks; no_index: no row.
  std::vector<FacetNodes> row_of_corner;
  Ragged<LocalIndex> facets_around;  ///< for each row: slave facets, ascending
  std::vector<double> kappa;         ///< for each row: 1 / int N_A over the reference slave surface [1/length^2]
  double edge = 0;                   ///< mean edge of the slave facets in the reference configuration [length]
};

/// reference: of all nodes. Throws (demand) if the node of a row has no slave facet of positive area.
MortarTopology make_topology(const MortarSurfaces& surfaces, std::span<const Vec3> reference);

/// A sparse matrix of vectors or blocks by row and node; nodes of a row in the order of their first contribution.
template <class Block>
struct NodeBlocks {
  Ragged<LocalIndex> nodes;
  std::vector<Block> blocks;  ///< one for each entry
  void clear() {
    nodes.clear();
    blocks.clear();
  }
  [[nodiscard]] std::span<const Block> row(LocalIndex i) const {
    const auto begin = static_cast<std::size_t>(nth(nodes.offsets, i));
    return {blocks.data() + begin, nodes.row(i).size()};
  }
};

struct MortarRows {
  NodeBlocks<double> weights;     ///< w_AK; of sum zero in each row [length^2]
  std::vector<Vec3> normals;      ///< unit, out of the master
  std::vector<Vec3> gap_vectors;  ///< G_A [length^3]
  std::vector<double> covered;    ///< sum of the slave's weights; 0: the row is empty [length^2]
  std::vector<double> gaps;       ///< normal . G, weighted [length^3]
  std::size_t segments = 0;       ///< number of pairs with a segment
};

/// A dense part of a matrix: values[(3 r + i) columns 3 + 3 c + j], added at (rows[r], i), (columns[c], j).
struct Patch {
  std::vector<LocalIndex> rows, columns;
  std::vector<double> values;
};

/// Parts of one matrix, to be added in this order. Patches beyond `count` are kept to reuse their memory.
struct Patches {
  std::vector<Patch> patch;
  std::vector<LocalIndex> source;  ///< of each: the slave facet or the row that it comes from
  std::size_t count = 0;
  Patch& next(LocalIndex from);
  void clear() { count = 0; }
};

struct MortarSlopes {
  NodeBlocks<Mat3> gap_vectors;  ///< dG_A / dx_K [length^2]
  NodeBlocks<Mat3> of_fixed;     ///< d(sum_L w_AL y_L) / dx_K of places y that do not move with x [length^2]
  NodeBlocks<Mat3> normals;      ///< d normal_A / dx_K [1/length]
  NodeBlocks<Vec3> covered;      ///< d covered_A / dx_K [length]
  Patches weights;               ///< sum_A T_A (x) dw_AK / dx_L at fixed tractions T, one patch for each slave facet
};

/// Work arrays of an evaluation, reused by the next.
struct MortarScratch;
struct MortarScratchDeleter {
  void operator()(MortarScratch* scratch) const;
};
using MortarScratchPointer = std::unique_ptr<MortarScratch, MortarScratchDeleter>;
MortarScratchPointer make_mortar_scratch();

/// candidates: for each slave facet, master facets in the order of their keys. x: current positions of all nodes.
void mortar_rows(const MortarSurfaces& surfaces, const MortarTopology& topology, const Ragged<LocalIndex>& candidates,
                 std::span<const Vec3> x, MortarScratch& scratch, MortarRows& rows);

/// The same with derivatives; tractions: T_A of each row at which `weights` is formed, followed by those of
/// MortarSurfaces::rows_elsewhere [force/length^2], or none: no patches; fixed: positions y of all nodes for
/// MortarSlopes::of_fixed, which otherwise remains empty [length]; transposed: tractions, as many as T, whose patches
/// are added transposed.
void mortar_rows_and_slopes(const MortarSurfaces& surfaces, const MortarTopology& topology,
                            const Ragged<LocalIndex>& candidates, std::span<const Vec3> x,
                            std::span<const Vec3> tractions, MortarScratch& scratch, MortarRows& rows,
                            MortarSlopes& slopes, std::span<const Vec3> fixed = {},
                            std::span<const Vec3> transposed = {});

}  // namespace brunt::contact
