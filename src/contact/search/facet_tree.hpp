// SPDX-License-Identifier: Apache-2.0
// Bounding volume trees over the facets of deforming surfaces: built once, refitted to the positions of every iterate,
// traversed in tandem (Yang and Laursen 2008, with the larger volume descended first). No physics, no messages.
//
// For a rigid triangulated surface use geometry::SlabTree: eight children at each node, in the axes of its body,
// queried with placements. Here all positions change between two searches, so a node has two children and its bounds
// are their union.
#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "contact/search/slab_bounds.hpp"
#include "core/aligned.hpp"
#include "core/types.hpp"

namespace brunt::contact {

/// Nodes at the corners, indices into the positions; the fourth of a triangle is no_index. Facets are numbered in the
/// order of their keys, so that results depending on these numbers are functions of the mesh.
using FacetNodes = std::array<LocalIndex, 4>;

/// A binary tree in preorder: the root first, then all of its first child, then all of its second. Each leaf is a
/// facet, so n facets have 2 n - 1 nodes. Its shape depends on the positions at which it was built.
template <int slabs>
struct FacetTree {
  AlignedVector<SlabBounds<slabs>> bounds;  ///< of each node, since the last refit
  std::vector<LocalIndex> link;             ///< of node i: its second child (the first is i + 1); of a leaf ~facet
  std::vector<FacetNodes> corners;          ///< of each leaf, in preorder; of a triangle the third is repeated

  [[nodiscard]] LocalIndex facets() const { return static_cast<LocalIndex>(corners.size()); }
  [[nodiscard]] LocalIndex nodes() const { return static_cast<LocalIndex>(link.size()); }
  [[nodiscard]] bool is_leaf(LocalIndex node) const { return nth(link, node) < 0; }
  [[nodiscard]] LocalIndex second_child(LocalIndex node) const { return nth(link, node); }
  [[nodiscard]] LocalIndex facet(LocalIndex leaf) const { return ~nth(link, leaf); }
  [[nodiscard]] std::size_t memory_bytes() const;
};

using BoxTree = FacetTree<3>;   ///< of boxes along the axes: for comparison
using KdopTree = FacetTree<9>;  ///< of 18-DOPs

/// Halves the facets at the median of their centres along the longest side of the box of these centres, equal centres
/// by their numbers, until one is left. O(n log n). All positions are finite. The bounds are set by `refit`.
template <int slabs>
void build(FacetTree<slabs>& tree, std::span<const FacetNodes> facets, std::span<const Vec3> positions);

/// Bounds of all nodes at these positions of the same nodes, leaves enlarged. One loop backwards, O(n), no allocation.
/// Two facets that are nearer than d overlap if each tree is enlarged by the distance d/2 (and by one rounding).
template <int slabs>
void refit(FacetTree<slabs>& tree, std::span<const Vec3> positions, const Enlargement& by);

struct FacetPair {
  LocalIndex slave = no_index, master = no_index;
  friend auto operator<=>(const FacetPair&, const FacetPair&) = default;
};

/// Work arrays of a traversal; reuse avoids all allocation.
struct TraversalScratch {
  std::vector<FacetPair> found;  ///< in the order of the traversal
  std::vector<LocalIndex> end;   ///< of each slave facet's pairs
};

/// Cost of a traversal. If the number of tests for each pair has doubled since the tree was built, its facets are no
/// longer in spatial order, and it should be rebuilt.
struct TraversalCounts {
  std::int64_t tests = 0;  ///< of two volumes, the roots included
  std::int64_t pairs = 0;
  [[nodiscard]] double tests_per_pair() const {
    return static_cast<double>(tests) / static_cast<double>(pairs > 0 ? pairs : 1);
  }
};

/// The node that is descended first when both of two overlapping nodes have children.
enum class Descent : std::int8_t {
  larger,  ///< the larger one (`width`), of equal ones the slave's
  slave,   ///< always the slave's, as the paper prints it
};

/// All pairs of facets whose bounds overlap, ordered by (slave, master). Replaces the content of `pairs`; allocates
/// only beyond the capacities. The pairs do not depend on the shapes of the trees, the number of tests does.
template <int slabs>
TraversalCounts find_pairs(const FacetTree<slabs>& slave, const FacetTree<slabs>& master, TraversalScratch& scratch,
                           std::vector<FacetPair>& pairs, Descent descent = Descent::larger);

}  // namespace brunt::contact
