// SPDX-License-Identifier: Apache-2.0
#include "brunt/contact/mortar/tie.hpp"

#include <Eigen/Eigenvalues>
#include <limits>
#include <optional>

#include "add_block.hpp"
#include "brunt/contact/mortar/corners.hpp"
#include "brunt/geometry/closest_point.hpp"
#include "turn.hpp"

namespace brunt::contact {

namespace {

/// The facet point nearest to a position, among the facets that may lie below these.
MasterPlace place_below(const MortarSurfaces& surfaces, std::span<const LocalIndex> facets,
                        const Ragged<LocalIndex>& candidates, std::span<const Vec3> x, const Vec3& place) {
  double nearest = std::numeric_limits<double>::infinity();
  MasterPlace below;
  for (const LocalIndex facet : facets)
    for (const LocalIndex master : candidates.row(facet)) {
      const FacetNodes& nodes = surfaces.master[static_cast<std::size_t>(master)];
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
                                     x[static_cast<std::size_t>(surfaces.rows[row])]);
}

Mat3 freedom_of(const MasterPlace& place, std::span<const Mat3> free) {
  if (place.nodes[0] == no_index) return Mat3::Identity();
  Mat3 sum = Mat3::Zero();
  for (std::size_t c = 0; c < place.nodes.size(); ++c)
    if (has_share(place.weights[c])) sum += free[static_cast<std::size_t>(place.nodes[c])];
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
    if (place.nodes[c] != no_index) offset -= place.weights[c] * of_nodes[static_cast<std::size_t>(place.nodes[c])];
  return offset;
}

TieStart tie(const MortarRows& rows) {
  return {rows.weights, rows.normals, rows.gap_vectors, rows.covered, {}};
}

void tie_residuals(const TieStart& start, std::span<const Vec3> x, std::span<const Vec3> normals,
                   std::vector<Vec3>& residuals) {
  residuals.assign(normals.size(), Vec3::Zero());
  for (std::size_t row = 0; row < normals.size(); ++row) {
    if (start.covered[row] == 0) continue;
    const Vec3 gap = weighted_sum(start.weights, static_cast<LocalIndex>(row), x);
    residuals[row] = (gap - turned(start.gap_vectors[row], start.normals[row], normals[row])) / start.covered[row];
  }
}

void tie_gradient(const TieStart& start, std::span<const Vec3> normals, const NodeBlocks<Mat3>& normal_slopes,
                  NodeBlocks<Mat3>& gradient) {
  gradient.clear();
  for (std::size_t row = 0; row < normals.size(); ++row) {
    const auto index = static_cast<LocalIndex>(row);
    const std::span<const LocalIndex> nodes = start.weights.nodes.row(index);
    if (start.covered[row] > 0) {
      const double over = 1 / start.covered[row];
      for (std::size_t k = 0; k < nodes.size(); ++k)
        add_block(gradient, nodes[k], Mat3(over * start.weights.row(index)[k] * Mat3::Identity()));
      add_row(gradient, -over * turned_slope(start.gap_vectors[row], start.normals[row], normals[row]), normal_slopes,
              index);
    }
    gradient.nodes.close_row();
  }
}

void add_tie_forces(const TieStart& start, std::span<const Vec3> tractions, std::span<Vec3> forces) {
  for (std::size_t row = 0; row < tractions.size(); ++row) {
    const std::span<const LocalIndex> nodes = start.weights.nodes.row(static_cast<LocalIndex>(row));
    for (std::size_t k = 0; k < nodes.size(); ++k)
      forces[static_cast<std::size_t>(nodes[k])] += start.weights.row(static_cast<LocalIndex>(row))[k] * tractions[row];
  }
}

}  // namespace brunt::contact
