// SPDX-License-Identifier: Apache-2.0
#include "brunt/contact/mortar/points.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "add_block.hpp"
#include "brunt/contact/mortar/corners.hpp"
#include "brunt/contact/mortar/normals.hpp"
#include "brunt/core/sorted.hpp"
#include "facet_map.hpp"
#include "normal_change.hpp"
#include "smooth_normal.hpp"

namespace brunt::contact {

namespace {

/// Distance from a rim over which rows fade out, in widths of the facet. It is small, since a corner near a rim is held
/// less, and large enough for Newton's method, which moves nodes by some hundredths of a facet in a correction.
constexpr double rim_width = 0.1;

/// Shape functions of a facet at the projection of a point along the facet's normal, and their gradients in space.
struct Projection {
  std::array<double, 4> value{};
  std::array<Vec3, 4> gradient{Vec3::Zero(), Vec3::Zero(), Vec3::Zero(), Vec3::Zero()};  ///< [1/length]

  Projection(const SlavePlane& plane, const Vec3& x) {
    const auto corners = static_cast<std::size_t>(plane.corners);
    const Vec3 from_centre = x - plane.centre;
    ShapeFunctions shape;
    shape_functions(FacetMap({plane.point.data(), corners}), broadcast(plane.first.dot(from_centre)),
                    broadcast(plane.second.dot(from_centre)), shape);
    for (std::size_t c = 0; c < corners; ++c) {
      value[c] = shape.value[c][0];
      gradient[c] = shape.by_x[c][0] * plane.first + shape.by_y[c][0] * plane.second;
    }
  }
};

/// The master facet below a node.
struct Hit {
  LocalIndex master = no_index;
  SlavePlane plane;
  double way = 0;  ///< along the node's normal to the facet [length]
};

/// Whether the line x + s along crosses the facet, seen along the line: two facets have their common side in common
/// there too, so that no line passes between them, however warped they are. (Projections along the normals of both
/// leave a gap or overlap, of the order of the warp times the angle between them.) The facet faces the line.
bool crosses(const FacetCorners& corners, const Vec3& x, const Vec3& along) {
  constexpr double beyond = 1e-6;  // of the facet's area: above rounding, for lines through a side
  std::array<double, 4> side{};    // twice the areas of the triangles between the point and the sides
  double whole = 0;
  for (std::size_t c = 0; c < corners.size(); ++c) {
    side[c] = along.dot((corners[c] - x).cross(corners[(c + 1) % corners.size()] - x));
    whole += side[c];
  }
  return whole < 0 && std::all_of(side.begin(), side.begin() + static_cast<std::ptrdiff_t>(corners.size()),
                                  [&](double area) { return area <= -beyond * whole; });
}

/// Finds the facet below the node of a row; none: no_index.
class Search {
 public:
  Search(const MortarSurfaces& surfaces, const MortarTopology& topology, const Ragged<LocalIndex>& candidates,
         std::span<const Vec3> x)
      : surfaces_(surfaces), topology_(topology), candidates_(candidates), x_(x) {}

  /// outward: the node's normal.
  Hit operator()(std::size_t row, const Vec3& outward) {
    Hit nearest;
    const Vec3& x = x_[static_cast<std::size_t>(surfaces_.rows[row])];
    const std::span<const LocalIndex> around = topology_.facets_around.row(static_cast<LocalIndex>(row));
    masters_.clear();
    for (const LocalIndex facet : around)
      masters_.insert(masters_.end(), candidates_.row(facet).begin(), candidates_.row(facet).end());
    sort_unique(masters_);
    for (const LocalIndex master : masters_) {
      Hit hit;
      hit.master = master;
      const auto index = static_cast<std::size_t>(master);
      const CornersOf corners(surfaces_.master[index], x_);
      if (!make_slave_plane(corners.span(), hit.plane) || !crosses(corners.span(), x, outward)) continue;
      const double facing = hit.plane.normal.dot(outward);
      if (!(facing < opposing_normals)) continue;
      hit.way = hit.plane.normal.dot(hit.plane.centre - x) / facing;
      const double gap = hit.plane.normal.dot(x - hit.plane.centre);
      if (gap > surfaces_.capture || -gap > deepest(around, index)) continue;
      if (nearest.master == no_index || std::abs(hit.way) < std::abs(nearest.way)) nearest = hit;
    }
    return nearest;
  }

 private:
  [[nodiscard]] double deepest(std::span<const LocalIndex> around, std::size_t master) const {
    double least = surfaces_.capture;
    for (const LocalIndex facet : around)
      least = std::min(least, surfaces_.deepest(static_cast<std::size_t>(facet), master));
    return least;
  }

  const MortarSurfaces& surfaces_;
  const MortarTopology& topology_;
  const Ragged<LocalIndex>& candidates_;
  std::span<const Vec3> x_;
  std::vector<LocalIndex> masters_;
};

/// Share of a row that fades out where the master ends, so that nodes that slide off a rim or lie flush with it have no
/// row that comes and goes: product of s^2 (3 - 2 s) over the rims, with s the way from the rim over `rim_width`, both
/// in widths of the facet. A corner at a rim of other facets only counts as well, so that the share is continuous.
struct Fading {
  double value = 1;
  std::array<double, 4> slope{};  ///< by the shape functions

  Fading(const NodePatches& patches, LocalIndex master, std::span<const double> shape) {
    const auto facet = static_cast<std::size_t>(master);
    const std::size_t corners = shape.size();
    const unsigned rims = patches.rims[facet];
    const auto is_rim = [&](std::size_t side) { return (rims >> side % corners & 1U) != 0; };
    for (std::size_t k = 0; k < corners; ++k) {
      const auto patch = static_cast<std::size_t>(patches.of_corner[facet][k]);
      if (is_rim(k)) fade_from({k, (k + 1) % corners}, shape);
      if (patches.at_rim[patch] != 0 && !is_rim(k) && !is_rim(k + corners - 1)) fade_from({k, k}, shape);
    }
  }

 private:
  /// A rim between two corners, or at one.
  void fade_from(const std::array<std::size_t, 2>& ends, std::span<const double> shape) {
    double way = 0;
    for (std::size_t c = 0; c < shape.size(); ++c)
      if (c != ends[0] && c != ends[1]) way += shape[c];
    const double s = std::clamp(way / rim_width, 0.0, 1.0), share = s * s * (3 - 2 * s);
    for (std::size_t c = 0; c < shape.size(); ++c) {
      slope[c] *= share;
      if (c != ends[0] && c != ends[1]) slope[c] += value * 6 * s * (1 - s) / rim_width;
    }
    value *= share;
  }
};

/// One row: the derivative of N_C by the node is gradient_C, by corner B - gradient_C . (N_B + height dn/dx_B), with n
/// the facet's normal. All weights have the factor of `Fading`.
class PointRow {
 public:
  PointRow(const MortarSurfaces& surfaces, LocalIndex node, double area, const Hit& hit, std::span<const Vec3> x)
      : node_(node),
        facet_(surfaces.master[static_cast<std::size_t>(hit.master)]),
        corners_(facet_, x),
        area_(area),
        x_(x[static_cast<std::size_t>(node)]),
        at_(hit.plane, x_),
        fading_(surfaces.master_patches, hit.master, {at_.value.data(), corners_.count}),
        facet_normal_(corners_.span()),
        normal_(surfaces, hit.master, at_.value, x) {
    below_.setZero();
    for (std::size_t c = 0; c < corners_.count; ++c) fading_slope_ += fading_.slope[c] * at_.gradient[c];
    for (std::size_t c = 0; c < corners_.count; ++c) below_ += at_.value[c] * (corners_.x[c] - x_);
    height_ = -facet_normal_.normal().dot(below_);
  }

  [[nodiscard]] const Vec3& normal() const { return normal_.value(); }
  [[nodiscard]] double covered() const { return fading_.value * area_; }
  [[nodiscard]] Vec3 gap_vector() const { return -covered() * below_; }

  void add_weights(NodeBlocks<double>& weights) const {
    put(weights, node_, covered());
    for (std::size_t c = 0; c < corners_.count; ++c) put(weights, facet_[c], -covered() * at_.value[c]);
  }
  void add_covered_slopes(NodeBlocks<Vec3>& slopes) const {
    put(slopes, node_, Vec3(area_ * fading_slope_));
    for (std::size_t b = 0; b < corners_.count; ++b)
      put(slopes, facet_[b], Vec3(-area_ * (moved(b).transpose() * fading_slope_)));
  }
  /// d(sum_L w_AL y_L)/dx at places y that do not move; with_x: they are x itself.
  void add_slopes(std::span<const Vec3> y, bool with_x, NodeBlocks<Mat3>& slopes) const {
    const double own = with_x ? covered() : 0.0;
    const Mat3 carried = covered() * sum_of(y) - area_ * difference_of(y) * fading_slope_.transpose();
    put(slopes, node_, Mat3(own * Mat3::Identity() - carried));
    for (std::size_t b = 0; b < corners_.count; ++b)
      put(slopes, facet_[b], Mat3(carried * moved(b) - own * at_.value[b] * Mat3::Identity()));
  }
  void add_normal_slopes(NodeBlocks<Mat3>& slopes) const {
    Mat3 by_place = Mat3::Zero();
    for (std::size_t c = 0; c < corners_.count; ++c) by_place += normal_.by_weight(c) * at_.gradient[c].transpose();
    put(slopes, node_, by_place);
    for (std::size_t b = 0; b < corners_.count; ++b) put(slopes, facet_[b], Mat3(-by_place * moved(b)));
    normal_.add_slopes(slopes);
  }
  /// T (x) dw_AK/dx_L + (dw_AK/dx_L)^T (x) S.
  void add_patch(const Vec3& traction, const Vec3& transposed, Patch& patch) const {
    patch.rows.assign(1, node_);
    patch.rows.insert(patch.rows.end(), facet_.begin(), facet_.begin() + static_cast<std::ptrdiff_t>(corners_.count));
    patch.columns = patch.rows;
    const std::size_t n = patch.rows.size(), width = 3 * n;
    patch.values.assign(width * width, 0.0);
    for (std::size_t k = 0; k < n; ++k)
      for (std::size_t l = 0; l < n; ++l) {
        const Vec3 by_node = weight_slope(k);
        const Vec3 slope = l == 0 ? by_node : Vec3(-moved(l - 1).transpose() * by_node);
        for (std::size_t i = 0; i < 3; ++i)
          for (std::size_t j = 0; j < 3; ++j) {
            const auto of = [](const Vec3& v, std::size_t c) { return v[static_cast<Eigen::Index>(c)]; };
            patch.values[(3 * k + i) * width + 3 * l + j] += of(traction, i) * of(slope, j);
            patch.values[(3 * l + j) * width + 3 * k + i] += of(transposed, i) * of(slope, j);
          }
      }
  }

 private:
  template <class Block>
  static void put(NodeBlocks<Block>& blocks, LocalIndex node, const Block& block) {
    blocks.nodes.values.push_back(node);
    blocks.blocks.push_back(block);
  }
  /// Motion of the point of the facet below the node by that of a corner.
  [[nodiscard]] Mat3 moved(std::size_t corner) const {
    return at_.value[corner] * Mat3::Identity() + height_ * facet_normal_.by_corner(corner);
  }
  /// Derivative of the weight of the node (0) or of a corner (from 1 on) by the node.
  [[nodiscard]] Vec3 weight_slope(std::size_t k) const {
    if (k == 0) return area_ * fading_slope_;
    return -area_ * (fading_.value * at_.gradient[k - 1] + at_.value[k - 1] * fading_slope_);
  }
  [[nodiscard]] Vec3 difference_of(std::span<const Vec3> y) const {
    Vec3 difference = Vec3::Zero();
    for (std::size_t c = 0; c < corners_.count; ++c)
      difference += at_.value[c] * (y[static_cast<std::size_t>(node_)] - y[static_cast<std::size_t>(facet_[c])]);
    return difference;
  }
  [[nodiscard]] Mat3 sum_of(std::span<const Vec3> y) const {
    const Vec3& origin = y[static_cast<std::size_t>(facet_[0])];
    Mat3 sum = Mat3::Zero();
    for (std::size_t c = 1; c < corners_.count; ++c)
      sum += (y[static_cast<std::size_t>(facet_[c])] - origin) * at_.gradient[c].transpose();
    return sum;
  }

  LocalIndex node_;
  const FacetNodes& facet_;
  CornersOf corners_;
  double area_;
  Vec3 x_, below_;  ///< the node; the point below it, from there
  Projection at_;
  Fading fading_;
  Vec3 fading_slope_ = Vec3::Zero();  ///< by the node [1/length]
  NormalChange facet_normal_;
  SmoothNormal normal_;
  double height_ = 0;  ///< of the node above the facet [length]
};

void evaluate(const MortarSurfaces& surfaces, const MortarTopology& topology, const Ragged<LocalIndex>& candidates,
              std::span<const Vec3> x, std::span<const Vec3> tractions, MortarRows& rows, MortarSlopes* slopes,
              std::span<const Vec3> fixed, std::span<const Vec3> transposed) {
  const std::size_t count = surfaces.rows.size();
  nodal_normals(surfaces, topology, x, rows.normals);
  rows.weights.clear();
  rows.gap_vectors.assign(count, Vec3::Zero());
  rows.covered.assign(count, 0);
  rows.gaps.assign(count, 0);
  rows.segments = 0;
  if (slopes != nullptr) {
    for (NodeBlocks<Mat3>* of : {&slopes->gap_vectors, &slopes->of_fixed, &slopes->normals}) of->clear();
    slopes->covered.clear();
    slopes->weights.clear();
  }
  Search search(surfaces, topology, candidates, x);
  for (std::size_t row = 0; row < count; ++row) {
    const Hit hit = search(row, -rows.normals[row]);
    if (hit.master != no_index) {
      const PointRow point(surfaces, surfaces.rows[row], 1 / topology.kappa[row], hit, x);
      rows.normals[row] = point.normal();
      rows.gap_vectors[row] = point.gap_vector();
      rows.covered[row] = point.covered();
      rows.gaps[row] = point.normal().dot(point.gap_vector());
      ++rows.segments;
      point.add_weights(rows.weights);
      if (slopes != nullptr) {
        point.add_slopes(x, true, slopes->gap_vectors);
        if (!fixed.empty()) point.add_slopes(fixed, false, slopes->of_fixed);
        point.add_covered_slopes(slopes->covered);
        point.add_normal_slopes(slopes->normals);
        const Vec3 traction = tractions.empty() ? Vec3(Vec3::Zero()) : tractions[row],
                   also = transposed.empty() ? Vec3(Vec3::Zero()) : transposed[row];
        if (!traction.isZero(0) || !also.isZero(0))
          point.add_patch(traction, also, slopes->weights.next(static_cast<LocalIndex>(row)));
      }
    }
    rows.weights.nodes.close_row();
    if (slopes == nullptr) continue;
    for (NodeBlocks<Mat3>* of : {&slopes->gap_vectors, &slopes->normals}) of->nodes.close_row();
    if (!fixed.empty()) slopes->of_fixed.nodes.close_row();
    slopes->covered.nodes.close_row();
  }
}

}  // namespace

void point_rows(const MortarSurfaces& surfaces, const MortarTopology& topology, const Ragged<LocalIndex>& candidates,
                std::span<const Vec3> x, MortarRows& rows) {
  evaluate(surfaces, topology, candidates, x, {}, rows, nullptr, {}, {});
}

void point_rows_and_slopes(const MortarSurfaces& surfaces, const MortarTopology& topology,
                           const Ragged<LocalIndex>& candidates, std::span<const Vec3> x,
                           std::span<const Vec3> tractions, MortarRows& rows, MortarSlopes& slopes,
                           std::span<const Vec3> fixed, std::span<const Vec3> transposed) {
  evaluate(surfaces, topology, candidates, x, tractions, rows, &slopes, fixed, transposed);
}

}  // namespace brunt::contact
