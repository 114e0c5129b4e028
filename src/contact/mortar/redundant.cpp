// SPDX-License-Identifier: Apache-2.0
#include "brunt/contact/mortar/redundant.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <unordered_map>

namespace brunt::contact {

namespace {

/// Scalar equations over the free directions of all nodes, in echelon form: an equation that those before it imply has
/// nothing left.
class Echelon {
 public:
  using Line = std::map<LocalIndex, double>;  ///< by 3 node + axis

  /// False: implied.
  bool add(Line line) {
    constexpr double rounding = 1e-6;  // of the largest entry: what a pivot of integrals must have to be one
    if (line.empty()) return false;
    const double size = std::abs(largest(line)->second);
    eliminate(line);
    if (line.empty()) return false;
    const auto pivot = largest(line);
    const double value = pivot->second;
    if (!(std::abs(value) > rounding * size)) return false;
    for (auto& entry : line) entry.second /= value;
    of_pivot_.emplace(pivot->first, lines_.size());
    pivots_.push_back(pivot->first);
    lines_.push_back(std::move(line));
    return true;
  }

 private:
  static Line::const_iterator largest(const Line& line) {
    return std::ranges::max_element(line, {}, [](const auto& entry) { return std::abs(entry.second); });
  }

  /// A kept line has no pivot of those before it: taken in their order, each is needed once.
  void eliminate(Line& line) const {
    std::set<std::size_t> to_do;
    const auto note = [&](LocalIndex column) {
      if (const auto kept = of_pivot_.find(column); kept != of_pivot_.end()) to_do.insert(kept->second);
    };
    for (const auto& entry : line) note(entry.first);
    while (!to_do.empty()) {
      const std::size_t k = *to_do.begin();
      to_do.erase(to_do.begin());
      const double factor = line[pivots_[k]];
      for (const auto& [column, value] : lines_[k]) {
        line[column] -= factor * value;
        note(column);
      }
      line.erase(pivots_[k]);
      to_do.erase(k);
    }
  }

  std::vector<Line> lines_;
  std::vector<LocalIndex> pivots_;                        ///< of each line
  std::unordered_map<LocalIndex, std::size_t> of_pivot_;  ///< the line of a pivot
};

/// The equation of one row along a direction.
Echelon::Line line_of(const Equations& equations, LocalIndex row, const Vec3& direction, std::span<const Mat3> free) {
  constexpr double none = 1e-12;  // of what is covered
  Echelon::Line line;
  const std::span<const LocalIndex> nodes = equations.weights->nodes.row(row);
  for (std::size_t k = 0; k < nodes.size(); ++k) {
    const Vec3 part = equations.weights->row(row)[k] * (free[static_cast<std::size_t>(nodes[k])] * direction);
    for (int axis = 0; axis < 3; ++axis)
      if (std::abs(part[axis]) > none * equations.covered[static_cast<std::size_t>(row)])
        line[3 * nodes[k] + axis] = part[axis];
  }
  return line;
}

/// Nodes that have a share in equations of more than one interface.
std::vector<std::uint8_t> shared_nodes(std::span<const Equations> interfaces, std::size_t nodes) {
  std::vector<std::uint8_t> shared(nodes, 0);
  if (interfaces.size() < 2) return shared;
  std::vector<std::int32_t> seen(nodes, -1);
  for (std::size_t k = 0; k < interfaces.size(); ++k)
    for (std::size_t row = 0; row < interfaces[k].held.size(); ++row) {
      if (interfaces[k].held[row].isZero(0)) continue;
      for (const LocalIndex node : interfaces[k].weights->nodes.row(static_cast<LocalIndex>(row))) {
        std::int32_t& before = seen[static_cast<std::size_t>(node)];
        if (before >= 0 && before != static_cast<std::int32_t>(k)) shared[static_cast<std::size_t>(node)] = 1;
        before = static_cast<std::int32_t>(k);
      }
    }
  return shared;
}

/// The directions of a row that have no unknown of their own, one a column.
Eigen::Matrix<double, 3, Eigen::Dynamic, 0, 3, 3> directions_to_look_at(const Mat3& held, const Mat3& free,
                                                                        bool shared) {
  Eigen::Matrix<double, 3, Eigen::Dynamic, 0, 3, 3> directions(3, 0);
  const Mat3 without = shared ? held : Mat3(held * (Mat3::Identity() - free) * held);
  if (without.isZero()) return directions;
  constexpr double own = 1e-9;  // what a direction that the node is free along at all has of eigenvalue below 1
  const Eigen::SelfAdjointEigenSolver<Mat3> axes(without);
  for (Eigen::Index k = 0; k < 3; ++k) {
    if (axes.eigenvalues()[k] < 1 - own) continue;
    directions.conservativeResize(Eigen::NoChange, directions.cols() + 1);
    directions.rightCols<1>() = axes.eigenvectors().col(k);
  }
  return directions;
}

class Elimination {
 public:
  Elimination(std::span<Equations> interfaces, std::span<const Mat3> free)
      : interfaces_(interfaces), free_(free), shared_(shared_nodes(interfaces, free.size())) {}

  void look_through(bool preferred) {
    for (Equations& equations : interfaces_)
      for (std::size_t row = 0; row < equations.held.size(); ++row)
        if ((equations.preferred.empty() || equations.preferred[row] != 0) == preferred) look_at(equations, row);
  }

 private:
  void look_at(Equations& equations, std::size_t row) {
    Mat3& held = equations.held[row];
    if (held.isZero(0)) return;
    const auto node = static_cast<std::size_t>(equations.slaves[row]);
    if (shared_[node] == 0 && free_[node].isIdentity(0)) return;
    const auto directions = directions_to_look_at(held, free_[node], shared_[node] != 0);
    for (const Vec3& direction : directions.colwise())
      if (!echelon_.add(line_of(equations, static_cast<LocalIndex>(row), direction, free_)))
        held -= direction * direction.transpose();
  }

  std::span<Equations> interfaces_;
  std::span<const Mat3> free_;
  std::vector<std::uint8_t> shared_;
  Echelon echelon_;
};

}  // namespace

void leave_out_implied(std::span<Equations> interfaces, std::span<const Mat3> free) {
  Elimination elimination(interfaces, free);
  elimination.look_through(true);
  elimination.look_through(false);
}

}  // namespace brunt::contact
