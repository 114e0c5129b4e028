// SPDX-License-Identifier: Apache-2.0
#include "brunt/contact/mortar/tie.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>

#include "add_block.hpp"
#include "brunt/contact/mortar/corners.hpp"
#include "brunt/geometry/closest_point.hpp"
#include "turn.hpp"

namespace brunt::contact {

namespace {

/// Sum of the projectors on the free directions of the nodes that have a share in the master's place under a node.
Mat3 freedom_below(const MortarSurfaces& surfaces, std::span<const LocalIndex> facets,
                   const Ragged<LocalIndex>& candidates, std::span<const Vec3> x, const Vec3& place,
                   std::span<const Mat3> free) {
  constexpr double share = 1e-6;  // coordinates in single precision
  double nearest = std::numeric_limits<double>::infinity();
  Mat3 sum = Mat3::Identity();
  for (const LocalIndex facet : facets)
    for (const LocalIndex master : candidates.row(facet)) {
      const FacetNodes& nodes = surfaces.master[static_cast<std::size_t>(master)];
      const CornersOf corners(nodes, x);
      const std::optional<geometry::FacePoint> point = geometry::closest_point(place, corners.span());
      if (!point || !((point->point - place).norm() < nearest)) continue;
      nearest = (point->point - place).norm();
      sum = Mat3::Zero();
      for (std::size_t c = 0; c < corners.count; ++c)
        if (point->weights[c] > share) sum += free[static_cast<std::size_t>(nodes[c])];
    }
  return sum;
}

/// Scalar equations of held slave nodes over the free directions of all nodes, in echelon form: an equation that those
/// before it imply has nothing left. (Equations of free slave nodes have their own unknowns there and are never
/// implied.)
class Echelon {
 public:
  using Line = std::map<LocalIndex, double>;  ///< by 3 node + axis

  /// False: implied.
  bool add(Line line) {
    constexpr double rounding = 1e-6;  // of the largest entry: what a pivot of integrals must have to be one
    const double size = largest(line)->second;
    for (const auto& [pivot, kept] : lines_) {
      const auto at = line.find(pivot);
      if (at == line.end()) continue;
      const double factor = at->second;
      for (const auto& [column, value] : kept) line[column] -= factor * value;
      line.erase(pivot);
    }
    if (line.empty()) return false;
    const auto pivot = largest(line);
    const double value = pivot->second;
    if (!(std::abs(value) > rounding * std::abs(size))) return false;
    const LocalIndex column = pivot->first;
    for (auto& entry : line) entry.second /= value;
    lines_.emplace_back(column, std::move(line));
    return true;
  }

 private:
  static Line::const_iterator largest(const Line& line) {
    return std::ranges::max_element(line, {}, [](const auto& entry) { return std::abs(entry.second); });
  }
  std::vector<std::pair<LocalIndex, Line>> lines_;
};

/// The equation of one row along a direction.
Echelon::Line line_of(const TieStart& start, LocalIndex row, const Vec3& direction, std::span<const Mat3> free) {
  constexpr double none = 1e-12;  // of what is covered
  Echelon::Line line;
  const std::span<const LocalIndex> nodes = start.weights.nodes.row(row);
  for (std::size_t k = 0; k < nodes.size(); ++k) {
    const Vec3 part = start.weights.row(row)[k] * (free[static_cast<std::size_t>(nodes[k])] * direction);
    for (int axis = 0; axis < 3; ++axis)
      if (std::abs(part[axis]) > none * start.covered[static_cast<std::size_t>(row)])
        line[3 * nodes[k] + axis] = part[axis];
  }
  return line;
}

/// Where a slave with more nodes than the master is driven, there are more equations than unknowns.
void leave_out_implied(const MortarSurfaces& surfaces, const TieStart& start, std::span<const Mat3> free,
                       std::vector<Mat3>& tied) {
  Echelon echelon;
  for (std::size_t row = 0; row < tied.size(); ++row) {
    const Mat3 held = tied[row] * (Mat3::Identity() - free[static_cast<std::size_t>(surfaces.rows[row])]) * tied[row];
    if (held.isZero()) continue;
    const Eigen::SelfAdjointEigenSolver<Mat3> axes(held);
    for (Eigen::Index k = 0; k < 3; ++k) {
      if (axes.eigenvalues()[k] < 0.5) continue;
      const Vec3 direction = axes.eigenvectors().col(k);
      Echelon::Line line = line_of(start, static_cast<LocalIndex>(row), direction, free);
      if (line.empty() || !echelon.add(std::move(line))) tied[row] -= direction * direction.transpose();
    }
  }
}

}  // namespace

std::vector<Mat3> tied_directions(const MortarSurfaces& surfaces, const MortarTopology& topology,
                                  const Ragged<LocalIndex>& candidates, std::span<const Vec3> x, const TieStart& start,
                                  std::span<const Mat3> free) {
  constexpr double none = 1e-9;  // eigenvalues of sums of projectors: directions that no node is free along
  std::vector<Mat3> tied(surfaces.rows.size(), Mat3::Zero());
  for (std::size_t row = 0; row < tied.size(); ++row) {
    if (start.covered[row] == 0) continue;
    tied[row] = Mat3::Identity();
    const auto node = static_cast<std::size_t>(surfaces.rows[row]);
    if (free[node].isIdentity()) continue;
    const auto around = topology.facets_around.row(static_cast<LocalIndex>(row));
    const Mat3 all = free[node] + freedom_below(surfaces, around, candidates, x, x[node], free);
    const Eigen::SelfAdjointEigenSolver<Mat3> axes(all);
    for (Eigen::Index k = 0; k < 3; ++k)
      if (axes.eigenvalues()[k] < none)
        tied[row] -= axes.eigenvectors().col(k) * axes.eigenvectors().col(k).transpose();
  }
  leave_out_implied(surfaces, start, free, tied);
  return tied;
}

TieStart tie(const MortarRows& rows) {
  return {rows.weights, rows.normals, rows.gap_vectors, rows.covered};
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
