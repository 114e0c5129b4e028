// SPDX-License-Identifier: Apache-2.0
#include "contact/mortar/tie.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "add_block.hpp"
#include "contact/mortar/corners.hpp"
#include "core/cells.hpp"
#include "facet_rows.hpp"
#include "geometry/closest_point.hpp"
#include "normal_change.hpp"

namespace brunt::contact {

namespace {

/// The facet point nearest to a position, among the facets that may lie below these.
MasterPlace place_below(const MortarSurfaces& surfaces, std::span<const LocalIndex> facets,
                        const Ragged<LocalIndex>& candidates, std::span<const Vec3> x, const Vec3& place) {
  double nearest = std::numeric_limits<double>::infinity();
  MasterPlace below;
  for (const LocalIndex facet : facets)
    for (const LocalIndex master : candidates.row(facet)) {
      const FacetNodes& nodes = nth(surfaces.master, master);
      const CornersOf corners(nodes, x);
      const std::optional<geometry::FacePoint> point = geometry::closest_point(place, corners.span());
      if (!point || !((point->point - place).norm() < nearest)) continue;
      nearest = (point->point - place).norm();
      below = {nodes, {}};
      for (std::size_t c = 0; c < corners.count; ++c) below.weights[c] = point->weights[c];
    }
  return below;
}

}  // namespace

void find_places_below(const MortarSurfaces& surfaces, const MortarTopology& topology,
                       const Ragged<LocalIndex>& candidates, std::span<const Vec3> x, TieStart& start) {
  start.below.assign(surfaces.rows.size(), {});
  for (std::size_t row = 0; row < surfaces.rows.size(); ++row)
    if (start.covered[row] > 0)
      start.below[row] = place_below(surfaces, topology.facets_around.row(static_cast<LocalIndex>(row)), candidates, x,
                                     nth(x, surfaces.rows[row]));
}

Mat3 freedom_of(const MasterPlace& place, std::span<const Mat3> free) {
  if (place.nodes[0] == no_index) return Mat3::Identity();
  Mat3 sum = Mat3::Zero();
  for (std::size_t c = 0; c < place.nodes.size(); ++c)
    if (has_share(place.weights[c])) sum += nth(free, place.nodes[c]);
  return sum;
}

Mat3 held_by_all(const Mat3& freedom) {
  constexpr double none = 1e-9;  // eigenvalues of sums of projectors: constrained directions of all nodes
  Mat3 held = Mat3::Zero();
  const Eigen::SelfAdjointEigenSolver<Mat3> axes(freedom);
  for (Eigen::Index k = 0; k < 3; ++k)
    if (axes.eigenvalues()[k] < none) held += axes.eigenvectors().col(k) * axes.eigenvectors().col(k).transpose();
  return held;
}

std::vector<Mat3> tied_directions(const MortarSurfaces& surfaces, const TieStart& start, std::span<const Mat3> free) {
  std::vector<Mat3> tied(surfaces.rows.size(), Mat3::Zero());
  for (std::size_t row = 0; row < tied.size(); ++row) {
    if (start.covered[row] == 0) continue;
    tied[row] = Mat3::Identity();
    const auto node = static_cast<std::size_t>(surfaces.rows[row]);
    if (free[node].isIdentity()) continue;
    tied[row] -= held_by_all(free[node] + freedom_of(start.below[row], free));
  }
  return tied;
}

Vec3 offset_from_below(const MasterPlace& place, const Vec3& of_slave, std::span<const Vec3> of_nodes) {
  Vec3 offset = of_slave;
  for (std::size_t c = 0; c < place.nodes.size(); ++c)
    if (place.nodes[c] != no_index) offset -= place.weights[c] * nth(of_nodes, place.nodes[c]);
  return offset;
}

namespace {

/// Height of a position that is the rounding of its coordinates: two roundings of each and of six partial sums.
double rounding_of_positions(std::span<const Vec3> x) {
  constexpr double roundings = 8;
  double largest = 0;
  for (const Vec3& place : x) largest = std::max(largest, place.cwiseAbs().maxCoeff());
  return roundings * std::numeric_limits<double>::epsilon() * largest;
}

NormalChange change_of(const FacetNodes& facet, std::span<const Vec3> x_before, std::span<const Vec3> x) {
  const CornersOf now(facet, x);
  if (x_before.empty()) return NormalChange(now.span());
  return {CornersOf(facet, x_before).span(), now.span()};
}

/// Calls visit(facet, height) for the slave facets around a row whose height differs from zero.
template <class Visit>
void for_heights(const TieStart& start, const MortarSurfaces& surfaces, const MortarTopology& topology, std::size_t row,
                 const Visit& visit) {
  if (!start.apart || start.covered[row] == 0) return;
  for (const LocalIndex index : topology.facets_around.row(static_cast<LocalIndex>(row))) {
    const auto facet = static_cast<std::size_t>(index);
    const FacetNodes& nodes = surfaces.slave[facet];
    const auto corner = static_cast<std::size_t>(std::ranges::find(nodes, surfaces.rows[row]) - nodes.begin());
    if (const double height = start.heights[facet][corner]; height != 0) visit(nodes, height);
  }
}

}  // namespace

TieStart tie_start(const MortarSurfaces& surfaces, const Ragged<LocalIndex>& candidates, std::span<const Vec3> x,
                   const MortarRows& rows) {
  TieStart start{rows.weights, rows.covered, {}, false, {}};
  start.heights.resize(surfaces.slave.size());
  const double rounding = rounding_of_positions(x);
  FacetRows of_facet;
  for (std::size_t facet = 0; facet < surfaces.slave.size(); ++facet) {
    if (!of_facet.evaluate(surfaces, facet, candidates.row(static_cast<LocalIndex>(facet)), x, false)) continue;
    const NormalChange change(CornersOf(surfaces.slave[facet], x).span());
    for (std::size_t j = 0; j < of_facet.corners(); ++j) {
      const double height = change.normal().dot(of_facet.gap_vector(j));
      if (!(std::abs(height) > rounding * of_facet.share(j))) continue;
      start.heights[facet][j] = height;
      start.apart = true;
    }
  }
  return start;
}

void tie_residuals(const TieStart& start, const MortarSurfaces& surfaces, const MortarTopology& topology,
                   std::span<const Vec3> x, std::vector<Vec3>& residuals) {
  residuals.assign(surfaces.rows.size(), Vec3::Zero());
  for (std::size_t row = 0; row < residuals.size(); ++row) {
    if (start.covered[row] == 0) continue;
    Vec3 left = weighted_sum(start.weights, static_cast<LocalIndex>(row), x);
    for_heights(start, surfaces, topology, row,
                [&](const FacetNodes& facet, double height) { left -= height * change_of(facet, {}, x).normal(); });
    residuals[row] = left / start.covered[row];
  }
}

void tie_levers(const TieStart& start, const MortarSurfaces& surfaces, const MortarTopology& topology,
                std::span<const Vec3> x_before, std::span<const Vec3> x, NodeBlocks<Mat3>& levers) {
  levers.clear();
  for (std::size_t row = 0; row < surfaces.rows.size(); ++row) {
    for_heights(start, surfaces, topology, row, [&](const FacetNodes& facet, double height) {
      const NormalChange change = change_of(facet, x_before, x);
      for (std::size_t k = 0; k < facet.size() && facet[k] != no_index; ++k)
        add_block(levers, facet[k], Mat3(-height * change.by_corner(k)));
    });
    levers.nodes.close_row();
  }
}

void tie_patches(const TieStart& start, const MortarSurfaces& surfaces, const MortarTopology& topology,
                 std::span<const Vec3> x_before, std::span<const Vec3> x, std::span<const Vec3> tractions,
                 Patches& patches) {
  patches.clear();
  for (std::size_t facet = 0; facet < surfaces.slave.size() && start.apart; ++facet) {
    if (!surfaces.is_ours(facet)) continue;
    const FacetNodes& nodes = surfaces.slave[facet];
    const std::size_t corners = cells::corner_count(nodes);
    Vec3 q = Vec3::Zero();
    for (std::size_t k = 0; k < corners; ++k)
      if (const LocalIndex row = topology.row_of_corner[facet][k]; row != no_index)
        q += start.heights[facet][k] * nth(tractions, row);
    if (q.isZero(0)) continue;
    const NormalChange change = change_of(nodes, x_before, x);
    Patch& patch = patches.next(static_cast<LocalIndex>(facet));
    patch.rows.assign(nodes.begin(), nodes.begin() + static_cast<std::ptrdiff_t>(corners));
    patch.columns = patch.rows;
    patch.values.assign(9 * corners * corners, 0.0);
    for (std::size_t a = 0; a < corners; ++a)
      for (std::size_t b = 0; b < corners; ++b)
        Eigen::Map<Eigen::Matrix<double, 3, 3, Eigen::RowMajor>, 0, Eigen::OuterStride<>>(
            patch.values.data() + 9 * corners * a + 3 * b,
            Eigen::OuterStride<>(static_cast<Eigen::Index>(3 * corners))) = -change.slope(q, a, b);
  }
}

}  // namespace brunt::contact
