// SPDX-License-Identifier: Apache-2.0
// Data computed once for each body: tree, mass properties, metric, interior points with their depth, convex pieces.
#pragma once
#include <span>
#include <vector>

#include "core/triangle_surface.hpp"
#include "depth/convex_pair.hpp"
#include "depth/metric.hpp"
#include "geometry/triangles/slab_tree.hpp"

namespace brunt::depth {

/// A ball inside the body.
struct InnerBall {
  Vec3 centre = Vec3::Zero();  ///< coordinates of the file [length]
  double depth = 0;            ///< of the centre: exact distance to the surface [length]
  double factor = 1;           ///< point_factor of the centre
};

/// Cubes that do not overlap, each inside the body.
struct InnerCells {
  double side = 0;             ///< [length]
  std::vector<Vec3> centres;   ///< coordinates of the file [length]
  std::vector<double> depths;  ///< of the centres [length]
};

struct Body {
  geometry::SlabTree tree;
  bool crosses_itself = false;   ///< then its depths, and bounds that rest on them, are not proven
  rigid::MassProperties mass;    ///< at density 1
  MetricShape shape;             ///< as the body that moves
  std::vector<Vec3> components;  ///< a point of each connected part of the surface
  std::vector<InnerBall> balls;  ///< the largest first
  InnerCells cells;
  std::vector<Vec3> outposts;       ///< vertices of the surface far from each other; coordinates of the file [length]
  std::vector<ConvexPiece> pieces;  ///< convex parts, each inside the body
  std::vector<double> piece_reach;  ///< greatest distance of a corner from the centroid [length]
  Mat3 axes = Mat3::Identity();     ///< columns: principal axes of J by growing moment, right-handed
  Vec3 moments = Vec3::Zero();      ///< principal moments of J [length^2]
};

struct BodyOptions {
  int balls = 400;                        ///< at most
  std::vector<std::vector<Vec3>> pieces;  ///< points of each; the caller guarantees that they are convex parts of the
                                          ///< body. None: the body itself if it is convex with few corners
  int cells = 1000;                       ///< see inner_cells
};

/// The surface must be closed and oriented outward; the caller checks this. Throws
/// std::invalid_argument for a surface without triangles or without a positive volume.
[[nodiscard]] Body make_body(const TriangleSurface& surface, const BodyOptions& options = {});

/// Interior points with their depths, on a grid of the bounding box along `axes` (orthonormal columns), each moved
/// inwards while the depth increases. A ball is omitted if a larger retained one contains nine tenths of it. The
/// largest first.
[[nodiscard]] std::vector<InnerBall> inner_balls(const geometry::SlabTree& tree, const MetricShape& shape,
                                                 const Mat3& axes, int most);

/// At most `most` of the points: first the one farthest from `centre`, then repeatedly the one farthest from the chosen
/// ones.
[[nodiscard]] std::vector<Vec3> spread_points(std::span<const Vec3> points, const Vec3& centre, int most);

/// About `count` cubes along `axes` (orthonormal columns) would fill the volume; cubes that the surface intersects are
/// omitted. volume: [length^3].
[[nodiscard]] InnerCells inner_cells(const geometry::SlabTree& tree, const MetricShape& shape, const Mat3& axes,
                                     double volume, int count);

}  // namespace brunt::depth
