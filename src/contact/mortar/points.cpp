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

/// Where the line x + s along crosses the facet; false if it does not, or the facet does not face it.
bool crosses(const Vec3& x, const Vec3& along, Hit& hit) {
  constexpr double inside = -1e-6;  // shape functions: above their rounding, so that no line passes between two facets
  const double facing = hit.plane.normal.dot(along);
  if (!(facing < opposing_normals)) return false;
  hit.way = hit.plane.normal.dot(hit.plane.centre - x) / facing;
  const Projection at(hit.plane, x + hit.way * along);
  return std::all_of(at.value.begin(), at.value.begin() + hit.plane.corners,
                     [](double value) { return value >= inside; });
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
      if (!make_slave_plane(CornersOf(surfaces_.master[index], x_).span(), hit.plane) || !crosses(x, outward, hit))
        continue;
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

/// One row: the derivative of N_C by the node is gradient_C, by corner B - gradient_C . (N_B + height dn/dx_B), with n
/// the facet's normal.
class PointRow {
 public:
  PointRow(const MortarSurfaces& surfaces, LocalIndex node, double area, const Hit& hit, std::span<const Vec3> x)
      : node_(node),
        facet_(surfaces.master[static_cast<std::size_t>(hit.master)]),
        corners_(facet_, x),
        area_(area),
        x_(x[static_cast<std::size_t>(node)]),
        at_(hit.plane, x_),
        facet_normal_(corners_.span()),
        normal_(surfaces, hit.master, at_.value, x) {
    below_.setZero();
    for (std::size_t c = 0; c < corners_.count; ++c) below_ += at_.value[c] * (corners_.x[c] - x_);
    height_ = -facet_normal_.normal().dot(below_);
  }

  [[nodiscard]] const Vec3& normal() const { return normal_.value(); }
  [[nodiscard]] Vec3 gap_vector() const { return -area_ * below_; }

  void add_weights(NodeBlocks<double>& weights) const {
    put(weights, node_, area_);
    for (std::size_t c = 0; c < corners_.count; ++c) put(weights, facet_[c], -area_ * at_.value[c]);
  }
  /// d(sum_L w_AL y_L)/dx at places y that do not move; with_x: they are x itself.
  void add_slopes(std::span<const Vec3> y, bool with_x, NodeBlocks<Mat3>& slopes) const {
    const Mat3 carried = sum_of(y);
    put(slopes, node_, Mat3(area_ * ((with_x ? 1.0 : 0.0) * Mat3::Identity() - carried)));
    for (std::size_t b = 0; b < corners_.count; ++b)
      put(slopes, facet_[b], Mat3(area_ * (carried * moved(b) - (with_x ? at_.value[b] : 0.0) * Mat3::Identity())));
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
    for (std::size_t c = 0; c < corners_.count; ++c)
      for (std::size_t l = 0; l < n; ++l) {
        const Vec3 slope =
            l == 0 ? Vec3(-area_ * at_.gradient[c]) : Vec3(area_ * (moved(l - 1).transpose() * at_.gradient[c]));
        for (std::size_t i = 0; i < 3; ++i)
          for (std::size_t j = 0; j < 3; ++j) {
            const auto of = [](const Vec3& v, std::size_t k) { return v[static_cast<Eigen::Index>(k)]; };
            patch.values[(3 * (c + 1) + i) * width + 3 * l + j] += of(traction, i) * of(slope, j);
            patch.values[(3 * l + j) * width + 3 * (c + 1) + i] += of(transposed, i) * of(slope, j);
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
      rows.covered[row] = 1 / topology.kappa[row];
      rows.gaps[row] = point.normal().dot(point.gap_vector());
      ++rows.segments;
      point.add_weights(rows.weights);
      if (slopes != nullptr) {
        point.add_slopes(x, true, slopes->gap_vectors);
        if (!fixed.empty()) point.add_slopes(fixed, false, slopes->of_fixed);
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
