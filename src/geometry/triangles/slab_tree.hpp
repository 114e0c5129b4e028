// SPDX-License-Identifier: Apache-2.0
// A bounding-volume tree over the triangles of one rigid surface, in the axes of its body: it is built once and queried
// with placements. Volumes are intersections of slabs (Klosowski et al. 1998, k-DOPs): three directions are boxes in
// body axes, more directions fit tighter. Eight children are stored together and tested at once.
//
// A placement `a_in_b` maps points of surface a to the axes of surface b: only the relative placement enters, and all
// points in results are in the axes of b. No query changes a tree, allocates (beyond the capacity of its output), or
// depends on the order of the triangles, except for their numbers in results.
#pragma once
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "core/aligned.hpp"
#include "core/simd.hpp"
#include "core/triangle_surface.hpp"
#include "geometry/box.hpp"
#include "geometry/triangles/triangle_pair.hpp"

namespace brunt::geometry {

/// Up to eight children: all nodes, or all triangles in a leaf. The box of a child is middle +- half along the axes of
/// the body, rounded outward; an unused lane has a half of -1e300.
struct alignas(64) SlabNode {
  Octet middle[3], half[3];           ///< [length]
  std::array<LocalIndex, 8> child{};  ///< a node, or in a leaf a triangle of the surface
  std::int32_t count = 0;             ///< children
  LocalIndex leaf = no_index;         ///< index into `leaves`; no_index: the children are nodes
};

/// The triangles of a leaf, component by component; unused lanes repeat the first.
struct alignas(64) SlabLeaf {
  Octet corner[3][3];  ///< [corner][component] [length]
  Octet normal[3];     ///< (corner 1 - corner 0) x (corner 2 - corner 0) [length^2]
  Octet inverse2[4];   ///< one over the squared lengths of the edges 0-1, 1-2, 2-0 and of the normal
};

/// Position of a point on a triangle, in the order of the normals in `TriangleNormals`: the face, the edges 0-1, 1-2,
/// 2-0, the corners.
enum class TriangleFeature : std::int8_t { face, edge0, edge1, edge2, corner0, corner1, corner2 };

/// Angle-weighted pseudo-normals of the features of a triangle (Baerentzen and Aanaes 2005): the sign of the distance
/// to a closed surface is that of their product with the vector from the nearest point. Zero if the triangles around
/// the feature have no unique normal; the sign then follows from solid angles.
using TriangleNormals = std::array<Vec3, 7>;

struct SlabTree {
  AlignedVector<SlabNode> nodes;  ///< the root first; empty for a surface without triangles
  AlignedVector<SlabLeaf> leaves;
  std::vector<Vec3> directions;          ///< unit, beyond the three axes
  AlignedVector<Octet> slabs;            ///< middle and half along these: node-wise, then direction-wise
  std::vector<Triangle> triangles;       ///< in the order of the surface
  std::vector<TriangleNormals> normals;  ///< the same order
  Box box;                               ///< of all triangles
};

/// Directions beyond the three axes for k-DOPs of `count` directions in all: 3 (none), 7 (space diagonals), 9 (face
/// diagonals) or 13 (both). Other counts throw std::invalid_argument.
std::vector<Vec3> more_directions(int count);

/// O(n log n). The points are finite and the corners of triangles in range; `directions`: in addition to the axes, of
/// any length except 0.
SlabTree build_slab_tree(const TriangleSurface& surface, std::span<const Vec3> directions = {});

/// Whether any triangle of a, placed, and any of b have a common point (triangles_cross with the corners placed and
/// rounded). A body inside the other crosses nothing: also use `contains`.
bool surfaces_cross(const SlabTree& a, const SlabTree& b, const Placement& a_in_b);

struct NearPair {
  LocalIndex a = no_index, b = no_index;          ///< triangles
  double distance = 0;                            ///< 0 where they cross [length]
  Vec3 on_a = Vec3::Zero(), on_b = Vec3::Zero();  ///< nearest points, in the axes of b [length]
};

/// All pairs of triangles at a distance below `band` [length], ordered by (a, b). Replaces the content of `out`.
void near_pairs(const SlabTree& a, const SlabTree& b, const Placement& a_in_b, double band, std::vector<NearPair>& out);

/// The smallest distance of the surfaces, 0 if they cross; `at_most` if the distance is larger than this [length].
double surface_distance(const SlabTree& a, const SlabTree& b, const Placement& a_in_b,
                        double at_most = std::numeric_limits<double>::infinity());

struct PointDepth {
  double depth = 0;                ///< signed distance to the surface, positive inside [length]
  Vec3 nearest = Vec3::Zero();     ///< point of the surface
  LocalIndex triangle = no_index;  ///< that holds it, of several the one with the least number
};

/// Depth of a point below a closed, consistently oriented surface without self-intersections. The distance is exact to
/// rounding; its sign is that of the nearest feature's pseudo-normal. At a point of the surface the depth is 0 up to
/// rounding.
PointDepth point_depth(const SlabTree& tree, const Vec3& x);

/// The same if the surface is not farther than `at_most` [length]; otherwise `triangle` is no_index and the depth is
/// +`at_most` with undetermined sign. If the depth d at a point y is known, |d| + |x - y| is a valid bound.
PointDepth point_depth(const SlabTree& tree, const Vec3& x, double at_most);

/// The depth if it is larger than `least`; otherwise some number not larger than `least` (-infinity if the sign was not
/// evaluated). Ends as soon as a triangle within `least` is found: for searches of the deepest point.
double depth_above(const SlabTree& tree, const Vec3& x, double least);

/// Whether the depth is positive or 0.
bool contains(const SlabTree& tree, const Vec3& x);

/// Winding number of a closed surface around a point: the sum of its solid angles / 4 pi (Van Oosterom and Strackee
/// 1983). 1 inside, 0 outside, up to rounding. O(n).
double winding_number(std::span<const Triangle> triangles, const Vec3& x);
double winding_number(const TriangleSurface& surface, const Vec3& x);

struct SelfCrossings {
  std::int64_t count = 0;                             ///< pairs of triangles
  LocalIndex first_a = no_index, first_b = no_index;  ///< the least pair by (a, b), a < b
};

/// Pairs of triangles of one surface with a common point other than a shared corner or edge: intersecting, touching,
/// folded onto each other, a corner on another edge, or duplicate triangles. Corners at the same position are shared,
/// whatever their numbers. Triangles without area are ignored.
SelfCrossings self_crossings(const SlabTree& tree);

/// The same, and the pseudo-normals of the triangles that cross, and of those with a corner in common with them, are
/// made zero: beside a crossing the nearest feature does not tell the side, so depths take their sign from solid
/// angles there. A sliver folded by rounding would make points far outside count as inside.
SelfCrossings distrust_crossings(SlabTree& tree);

}  // namespace brunt::geometry
