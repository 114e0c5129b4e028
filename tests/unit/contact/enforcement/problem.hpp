// SPDX-License-Identifier: Apache-2.0
// Mass points and rows for tests of enforcement.
#pragma once
#include <random>
#include <vector>

#include "contact/enforcement/enforce.hpp"

namespace brunt::contact {

struct Problem {
  std::vector<Row> rows;
  mutable RowMatrix matrix;
  std::vector<NodeMotion> motion;
  std::vector<Mobility> mobility;
  std::vector<Vec3> impulses;
  std::vector<Vec3> velocity;

  LocalIndex add_node(double mass, const Vec3& v) {
    motion.push_back({Vec3::Zero(), v, v});
    mobility.push_back({1 / mass, Mat3::Identity()});
    return static_cast<LocalIndex>(motion.size()) - 1;
  }
  Row& add_row(std::initializer_list<std::pair<LocalIndex, double>> terms, const Vec3& normal, double required = 0) {
    Row row{.key = {}, .normal = normal, .required = required};
    for (const auto& [node, weight] : terms) {
      row.nodes[static_cast<std::size_t>(row.node_count)] = node;
      row.weights[static_cast<std::size_t>(row.node_count++)] = weight;
    }
    rows.push_back(row);
    return rows.back();
  }
  /// One slave over four corners of a cell at (a, b) in [0, 1]^2.
  Row& add_row_over(LocalIndex slave, const std::array<LocalIndex, 4>& corners, double a, double b,
                    const Vec3& normal) {
    return add_row({{slave, 1},
                    {corners[0], -(1 - a) * (1 - b)},
                    {corners[1], -a * (1 - b)},
                    {corners[2], -a * b},
                    {corners[3], -(1 - a) * b}},
                   normal);
  }
  EnforcementResult solve(const EnforcementSettings& settings, double dt = 1) {
    OneRankExchange exchange;
    EnforcementScratch scratch;
    impulses.resize(rows.size(), Vec3::Zero());
    velocity.resize(motion.size());
    return enforce(system(), settings, dt, exchange, impulses, velocity, scratch);
  }
  [[nodiscard]] System system(bool two_passes = false) const {
    return {compress(rows, matrix), motion, mobility, two_passes};
  }
  [[nodiscard]] double rate(std::size_t q) const { return rows[q].normal.dot(relative_velocity(rows[q], velocity)); }
  [[nodiscard]] double push(std::size_t q) const { return rows[q].normal.dot(impulses[q]); }
  [[nodiscard]] Vec3 momentum_change() const {
    Vec3 change = Vec3::Zero();
    for (std::size_t n = 0; n < motion.size(); ++n)
      change += (velocity[n] - motion[n].predicted) / mobility[n].inverse_mass;
    return change;
  }
  [[nodiscard]] double kinetic(bool after) const {
    double energy = 0;
    for (std::size_t n = 0; n < motion.size(); ++n)
      energy += 0.5 / mobility[n].inverse_mass * (after ? velocity[n] : motion[n].predicted).squaredNorm();
    return energy;
  }
};

/// One node over a fixed plane.
inline Problem lone_node(double gap, double speed, double mass = 2) {
  Problem p;
  p.add_node(mass, {0, 0, speed});
  p.add_row({{0, 1}}, Vec3::UnitZ()).gap = gap;
  return p;
}

/// A grid of n x n slaves over a grid of m x m masters, both on the unit square, approaching at 1 with some noise.
/// Masses are those of nodes: `slave_mass`, `master_mass` a unit of area, halved at edges.
inline Problem patch(int n, int m, double slave_mass, double master_mass, unsigned seed = 1) {
  Problem p;
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> noise(-0.1, 0.1);
  const auto area = [](int i, int j, int count) {
    const double edge_i = i == 0 || i == count - 1 ? 0.5 : 1.0, edge_j = j == 0 || j == count - 1 ? 0.5 : 1.0;
    return edge_i * edge_j / ((count - 1) * (count - 1));
  };
  for (int j = 0; j < m; ++j)
    for (int i = 0; i < m; ++i) p.add_node(master_mass * area(i, j, m), {0, 0, 0});
  for (int j = 0; j < n; ++j) {
    for (int i = 0; i < n; ++i) {
      const LocalIndex slave = p.add_node(slave_mass * area(i, j, n), {0, 0, -1 + noise(random)});
      const double x = static_cast<double>(i) / (n - 1) * (m - 1), y = static_cast<double>(j) / (n - 1) * (m - 1);
      const int cell_x = std::min(static_cast<int>(x), m - 2), cell_y = std::min(static_cast<int>(y), m - 2);
      const LocalIndex corner = cell_y * m + cell_x;
      p.add_row_over(slave, {corner, corner + 1, corner + 1 + m, corner + m}, x - cell_x, y - cell_y, Vec3::UnitZ());
    }
  }
  return p;
}

/// A patch of slave points over a grid of master points, with random weights, masses and velocities.
inline Problem random_patch(unsigned seed) {
  Problem p;
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> mass(0.5, 20), place(-1, 1), speed(-1, 1);
  constexpr int cells = 4;
  for (int i = 0; i < (cells + 1) * (cells + 1); ++i) p.add_node(mass(random), {speed(random), speed(random), 2});
  for (int i = 0; i < cells; ++i) {
    for (int j = 0; j < cells; ++j) {
      for (int k = 0; k < 3; ++k) {
        const LocalIndex slave = p.add_node(mass(random), {speed(random), speed(random), -1 - speed(random)});
        const double a = 0.5 * (1 + place(random)), b = 0.5 * (1 + place(random));
        const LocalIndex corner = i * (cells + 1) + j;
        p.add_row_over(slave, {corner, corner + 1, corner + cells + 2, corner + cells + 1}, a, b,
                       Vec3(0.1 * place(random), 0, 1).normalized())
            .required = k == 0 ? -0.5 : 0.0;
      }
    }
  }
  return p;
}

}  // namespace brunt::contact
