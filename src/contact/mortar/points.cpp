// SPDX-License-Identifier: Apache-2.0
#include "contact/mortar/points.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "add_block.hpp"
#include "contact/mortar/corners.hpp"
#include "contact/mortar/normals.hpp"
#include "core/sorted.hpp"
#include "facet_map.hpp"
#include "smooth_normal.hpp"

namespace brunt::contact {

namespace {

/// Distance from a rim over which rows fade out, in widths of the facet. It is small, since a corner near a rim is held
/// less, and large enough for Newton's method, which moves nodes by some hundredths of a facet in a correction.
constexpr double rim_width = 0.1;

/// Shape functions of a facet where a line through a point crosses it, and their gradients in space. Facets are seen
/// along the line, where neighbours have their common side in common: values and functions are continuous from facet to
/// facet, and no line passes between two of them, however warped they are. (Projections along the normals of both jump,
/// and leave gaps and overlaps, by the warp times the angle between them.)
struct Crossing {
  std::array<double, 4> value{};
  std::array<Vec3, 4> gradient{Vec3::Zero(), Vec3::Zero(), Vec3::Zero(), Vec3::Zero()};  ///< across the line [1/length]

  /// along: unit; the facet faces it.
  Crossing(FacetCorners corners, const Vec3& x, const Vec3& along) {
    const Vec3 first = along.unitOrthogonal(), second = first.cross(along);  // seen from the outside of the facet
    std::array<geometry::PlanePoint<double>, 4> point{};
    for (std::size_t c = 0; c < corners.size(); ++c) point[c] = {first.dot(corners[c] - x), second.dot(corners[c] - x)};
    ShapeFunctions shape;
    shape_functions(FacetMap({point.data(), corners.size()}), Pack{}, Pack{}, shape);
    for (std::size_t c = 0; c < corners.size(); ++c) {
      value[c] = shape.value[c][0];
      gradient[c] = shape.by_x[c][0] * first + shape.by_y[c][0] * second;
    }
  }
};

/// Whether the line x + s along crosses the facet, seen along the line. The facet faces the line.
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
  LocalIndex operator()(std::size_t row, const Vec3& outward) {
    LocalIndex nearest = no_index;
    double least = std::numeric_limits<double>::infinity();
    const Vec3& x = nth(x_, surfaces_.rows[row]);
    const std::span<const LocalIndex> around = topology_.facets_around.row(static_cast<LocalIndex>(row));
    masters_.clear();
    for (const LocalIndex facet : around)
      masters_.insert(masters_.end(), candidates_.row(facet).begin(), candidates_.row(facet).end());
    sort_unique(masters_);
    SlavePlane plane;
    for (const LocalIndex master : masters_) {
      const CornersOf corners(nth(surfaces_.master, master), x_);
      if (!make_slave_plane(corners.span(), plane) || !(plane.normal.dot(outward) < opposing_normals) ||
          !crosses(corners.span(), x, outward))
        continue;
      const double gap = plane.normal.dot(x - plane.centre), way = std::abs(gap / plane.normal.dot(outward));
      if (gap > surfaces_.capture || -gap > deepest(around, static_cast<std::size_t>(master)) || !(way < least))
        continue;
      nearest = master;
      least = way;
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

/// The node of a row, and the direction in which it looks.
struct PointNode {
  LocalIndex node = no_index;
  Vec3 x, outward;
  std::span<const LocalIndex> turned_by{};  ///< nodes on whose positions the direction depends; for derivatives only
  std::span<const Mat3> turns{};            ///< derivatives of -outward [1/length]
};

/// One row. With h the way to the facet the derivative of N_C is gradient_C . (dx - sum_B N_B dx_B + h d(outward)). All
/// weights have the factor of `Fading`.
class PointRow {
 public:
  PointRow(const MortarSurfaces& surfaces, const PointNode& point, double area, LocalIndex master,
           std::span<const Vec3> x)
      : facet_(nth(surfaces.master, master)),
        corners_(facet_, x),
        area_(area),
        at_(corners_.span(), point.x, point.outward),
        fading_(surfaces.master_patches, master, {at_.value.data(), corners_.count}),
        normal_(surfaces, master, at_.value, x) {
    for (std::size_t c = 0; c < corners_.count; ++c) {
      below_ += at_.value[c] * (corners_.x[c] - point.x);
      fading_slope_ += fading_.slope[c] * at_.gradient[c];
    }
    nodes_.push_back(point.node);
    motion_.push_back(Mat3::Identity());
    for (std::size_t c = 0; c < corners_.count; ++c) {
      nodes_.push_back(facet_[c]);
      motion_.push_back(-at_.value[c] * Mat3::Identity());
    }
    for (std::size_t k = 0; k < point.turns.size(); ++k) {
      nodes_.push_back(point.turned_by[k]);
      motion_.push_back(-below_.dot(point.outward) * point.turns[k]);
    }
  }

  [[nodiscard]] const Vec3& normal() const { return normal_.value(); }
  [[nodiscard]] double covered() const { return fading_.value * area_; }
  [[nodiscard]] Vec3 gap_vector() const { return -covered() * below_; }

  void add_weights(NodeBlocks<double>& weights) const {
    for (std::size_t k = 0; k < weighted(); ++k) add_block(weights, nodes_[k], weight(k));
  }
  void add_covered_slopes(NodeBlocks<Vec3>& slopes) const {
    for (std::size_t l = 0; l < nodes_.size(); ++l)
      add_block(slopes, nodes_[l], Vec3(area_ * (motion_[l].transpose() * fading_slope_)));
  }
  /// d(sum_L w_AL y_L)/dx at places y that do not move; with_x: they are x itself.
  void add_slopes(std::span<const Vec3> y, bool with_x, NodeBlocks<Mat3>& slopes) const {
    const Vec3& origin = nth(y, nodes_[0]);
    Mat3 carried = Mat3::Zero();
    for (std::size_t k = 1; k < weighted(); ++k) carried += (nth(y, nodes_[k]) - origin) * weight_slope(k).transpose();
    for (std::size_t l = 0; l < nodes_.size(); ++l) {
      const double own = with_x && l < weighted() ? weight(l) : 0.0;
      add_block(slopes, nodes_[l], Mat3(carried * motion_[l] + own * Mat3::Identity()));
    }
  }
  void add_normal_slopes(NodeBlocks<Mat3>& slopes) const {
    Mat3 by_place = Mat3::Zero();
    for (std::size_t c = 0; c < corners_.count; ++c) by_place += normal_.by_weight(c) * at_.gradient[c].transpose();
    for (std::size_t l = 0; l < nodes_.size(); ++l) add_block(slopes, nodes_[l], Mat3(by_place * motion_[l]));
    normal_.add_slopes(slopes);
  }
  /// T (x) dw_AK/dx_L + (dw_AK/dx_L)^T (x) S.
  void add_patch(const Vec3& traction, const Vec3& transposed, Patch& patch) const {
    patch.rows = nodes_;
    patch.columns = nodes_;
    const std::size_t n = nodes_.size(), width = 3 * n;
    patch.values.assign(width * width, 0.0);
    for (std::size_t k = 0; k < weighted(); ++k)
      for (std::size_t l = 0; l < n; ++l) {
        const Vec3 slope = motion_[l].transpose() * weight_slope(k);
        for (std::size_t i = 0; i < 3; ++i)
          for (std::size_t j = 0; j < 3; ++j) {
            const auto of = [](const Vec3& v, std::size_t c) { return v[static_cast<Eigen::Index>(c)]; };
            patch.values[(3 * k + i) * width + 3 * l + j] += of(traction, i) * of(slope, j);
            patch.values[(3 * l + j) * width + 3 * k + i] += of(transposed, i) * of(slope, j);
          }
      }
  }

 private:
  /// Of the row's node (0) and of the corners (from 1 on).
  [[nodiscard]] std::size_t weighted() const { return 1 + corners_.count; }
  [[nodiscard]] double weight(std::size_t k) const { return k == 0 ? covered() : -covered() * at_.value[k - 1]; }
  /// Its derivative by the place of the node relative to the facet.
  [[nodiscard]] Vec3 weight_slope(std::size_t k) const {
    if (k == 0) return area_ * fading_slope_;
    return -area_ * (fading_.value * at_.gradient[k - 1] + at_.value[k - 1] * fading_slope_);
  }

  const FacetNodes& facet_;
  CornersOf corners_;
  double area_;
  Crossing at_;
  Fading fading_;
  SmoothNormal normal_;
  Vec3 below_ = Vec3::Zero();         ///< the point below the node, from there
  Vec3 fading_slope_ = Vec3::Zero();  ///< [1/length]
  std::vector<LocalIndex> nodes_;     ///< the row's node, the corners, and those that turn its direction
  std::vector<Mat3> motion_;          ///< by each: of the node relative to the facet
};

void evaluate(const MortarSurfaces& surfaces, const MortarTopology& topology, const Ragged<LocalIndex>& candidates,
              std::span<const Vec3> x, std::span<const Vec3> tractions, MortarRows& rows, MortarSlopes* slopes,
              std::span<const Vec3> fixed, std::span<const Vec3> transposed) {
  const std::size_t count = surfaces.rows.size();
  NodeBlocks<Mat3> turns;
  nodal_normals(surfaces, topology, x, rows.normals, slopes != nullptr ? &turns : nullptr);
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
    PointNode node{surfaces.rows[row], nth(x, surfaces.rows[row]), -rows.normals[row]};
    if (slopes != nullptr) {
      node.turned_by = turns.nodes.row(static_cast<LocalIndex>(row));
      node.turns = turns.row(static_cast<LocalIndex>(row));
    }
    if (const LocalIndex master = search(row, node.outward); master != no_index) {
      const PointRow point(surfaces, node, 1 / topology.kappa[row], master, x);
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
