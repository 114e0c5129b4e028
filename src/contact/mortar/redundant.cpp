// SPDX-License-Identifier: Apache-2.0
#include "contact/mortar/redundant.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <set>

namespace brunt::contact {

namespace {

Line::const_iterator largest(const Line& line) {
  return std::ranges::max_element(line, {}, [](const auto& entry) { return std::abs(entry.second); });
}

Line line_of(const Equations& equations, std::size_t row, const Vec3& direction, const EquationNodes& of) {
  constexpr double none = 1e-12;  // share of the covered area
  Line line;
  const auto index = static_cast<LocalIndex>(row);
  const auto add = [&](LocalIndex place, const Vec3& slope) {
    const auto node = static_cast<std::size_t>(place);
    const Vec3 part = of.free[node] * slope;
    for (int axis = 0; axis < 3; ++axis)
      if (std::abs(part[axis]) > none * equations.covered[row]) line[3 * of.number[node] + axis] += part[axis];
  };
  const std::span<const LocalIndex> nodes = equations.weights->nodes.row(index);
  for (std::size_t k = 0; k < nodes.size(); ++k) add(nodes[k], equations.weights->row(index)[k] * direction);
  if (equations.levers == nullptr) return line;
  const std::span<const LocalIndex> turned = equations.levers->nodes.row(index);
  for (std::size_t k = 0; k < turned.size(); ++k)
    add(turned[k], equations.levers->row(index)[k].transpose() * direction);
  return line;
}

/// The directions of a row without an unknown of their own, one in each column.
Eigen::Matrix<double, 3, Eigen::Dynamic, 0, 3, 3> directions_to_look_at(const Mat3& held, const Mat3& free,
                                                                        bool shared) {
  Eigen::Matrix<double, 3, Eigen::Dynamic, 0, 3, 3> directions(3, 0);
  const Mat3 without = shared ? held : Mat3(held * (Mat3::Identity() - free) * held);
  if (without.isZero()) return directions;
  constexpr double own = 1e-9;  // tolerance of the eigenvalue 1 of a free direction of the node
  const Eigen::SelfAdjointEigenSolver<Mat3> axes(without);
  for (Eigen::Index k = 0; k < 3; ++k) {
    if (axes.eigenvalues()[k] < 1 - own) continue;
    directions.conservativeResize(Eigen::NoChange, directions.cols() + 1);
    directions.rightCols<1>() = axes.eigenvectors().col(k);
  }
  return directions;
}

}  // namespace

bool Echelon::add(Line line) {
  constexpr double rounding = 1e-6;  // least pivot over the largest entry: smaller ones are errors of the integrals
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

/// A stored line has no pivots of previous lines, so in their order each is applied once.
void Echelon::eliminate(Line& line) const {
  std::set<std::size_t> to_do;
  const auto note = [&](GlobalIndex column) {
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

std::vector<RowLine> lines_to_look_at(const Equations& equations, const EquationNodes& nodes) {
  std::vector<RowLine> lines;
  for (std::size_t row = 0; row < equations.held.size(); ++row) {
    const Mat3& held = equations.held[row];
    const auto node = static_cast<std::size_t>(equations.slaves[row]);
    const bool shared = nodes.shared[node] != 0;
    if (held.isZero(0) || (!shared && nodes.free[node].isIdentity(0))) continue;
    const auto directions = directions_to_look_at(held, nodes.free[node], shared);
    for (const Vec3& direction : directions.colwise())
      lines.push_back({row, direction, line_of(equations, row, direction, nodes)});
  }
  return lines;
}

}  // namespace brunt::contact
