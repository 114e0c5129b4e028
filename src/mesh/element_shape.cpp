// SPDX-License-Identifier: Apache-2.0
// Legal collapses and Jacobians of single elements.
#include "element_shape.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <bit>

#include "core/cells.hpp"
#include "mesh/topology.hpp"

namespace brunt::mesh {
namespace {

using Corners = unsigned;  // a set of local corners, one bit each

constexpr Corners bit(int corner) {
  return 1U << corner;
}

bool is_edge(Corners set) {
  if (std::popcount(set) != 2) return false;
  const int corner = std::countr_zero(set);
  for (const int other : nth(cells::hex_neighbours, corner))
    if (set == (bit(corner) | bit(other))) return true;
  return false;
}

bool is_face(Corners set) {
  for (const auto& face : cells::hex_faces) {
    Corners corners = 0;
    for (const int c : face) corners |= bit(c);
    if (set == corners) return true;
  }
  return false;
}

double scaled_triple_product(const Vec3& a, const Vec3& b, const Vec3& c) {
  const double lengths = a.norm() * b.norm() * c.norm();
  return lengths > 0 ? a.cross(b).dot(c) / lengths : 0.0;
}

WorstJacobian worst_of_shell(Shape shape, const LocalIndex* element, const std::vector<Vec3>& coordinates) {
  const int count = nodes_per_element(shape);
  const auto x = [&](int k) -> const Vec3& { return nth(coordinates, element[k % count]); };
  const Vec3 normal = (x(2) - x(0)).cross(x(count - 1) - x(1)).stableNormalized();  // of a triangle edges 0-2 and 1-2
  WorstJacobian worst{1, 0};
  for (int k = 0; k < count; ++k) {
    const double scaled = scaled_triple_product(x(k + 1) - x(k), x(k + count - 1) - x(k), normal);
    if (!(scaled >= worst.scaled)) worst = {scaled, k};
  }
  return worst;
}

}  // namespace

bool corners_are_legal(Shape shape, const LocalIndex* element) {
  std::vector<Corners> repeated;
  const int count = nodes_per_element(shape);
  Corners seen = 0;
  for (int i = 0; i < count; ++i) {
    if (seen & bit(i)) continue;
    Corners same = 0;
    for (int j = i; j < count; ++j)
      if (element[j] == element[i]) same |= bit(j);
    seen |= same;
    if (std::popcount(same) > 1) repeated.push_back(same);
  }
  if (repeated.empty()) return true;
  if (shape != Shape::hex8) return false;
  if (repeated.size() == 1) return is_face(repeated[0]);
  if (repeated.size() > 2) return false;
  const auto [fewer, more] =
      std::minmax(repeated[0], repeated[1], [](Corners a, Corners b) { return std::popcount(a) < std::popcount(b); });
  return is_edge(fewer) && (is_face(more) || (is_edge(more) && is_face(fewer | more)));
}

WorstJacobian worst_jacobian(Shape shape, const LocalIndex* element, const std::vector<Vec3>& coordinates) {
  const auto x = [&](int k) -> const Vec3& { return nth(coordinates, element[k]); };
  if (cells::is_surface(shape)) return worst_of_shell(shape, element, coordinates);
  if (shape == Shape::tet4) return {scaled_triple_product(x(1) - x(0), x(2) - x(0), x(3) - x(0)), -1};
  const Vec3 xi = x(1) + x(2) + x(5) + x(6) - x(0) - x(3) - x(4) - x(7);
  const Vec3 eta = x(2) + x(3) + x(6) + x(7) - x(0) - x(1) - x(4) - x(5);
  const Vec3 zeta = x(4) + x(5) + x(6) + x(7) - x(0) - x(1) - x(2) - x(3);
  WorstJacobian worst{scaled_triple_product(xi, eta, zeta), -1};
  for (int k = 0; k < 8; ++k) {
    const auto& ends = nth(cells::hex_neighbours, k);
    const bool collapsed = std::any_of(ends.begin(), ends.end(), [&](int e) { return element[e] == element[k]; });
    if (collapsed) continue;
    const double scaled = scaled_triple_product(x(ends[0]) - x(k), x(ends[1]) - x(k), x(ends[2]) - x(k));
    if (!(scaled >= worst.scaled)) worst = {scaled, k};
  }
  return worst;
}

}  // namespace brunt::mesh
