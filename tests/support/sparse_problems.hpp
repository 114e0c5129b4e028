// SPDX-License-Identifier: Apache-2.0
// Sparse systems to solve: blocks of linear elastic hexahedra, held or free, tied to each other by multipliers.
#pragma once
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <vector>

#include "comm/linear_system.hpp"

namespace brunt::test {

using SparseMatrix = std::vector<std::map<GlobalIndex, double>>;  // by row: entries by column

struct ElasticBlock {
  std::array<int, 3> elements;
  bool held = false;  // the nodes at z = 0
  double modulus = 1;
  std::array<double, 3> size{1, 1, 1};
  [[nodiscard]] GlobalIndex node(int x, int y, int z) const {
    return x + (elements[0] + 1) * (y + GlobalIndex{elements[1] + 1} * z);
  }
  [[nodiscard]] GlobalIndex unknowns() const { return 3 * (node(elements[0], elements[1], elements[2]) + 1); }
};

/// The stiffness of one element, Poisson's ratio 0.3, two Gauss points an axis.
inline std::array<std::array<double, 24>, 24> element_stiffness(const ElasticBlock& block) {
  constexpr double poisson = 0.3;
  const double lambda = block.modulus * poisson / ((1 + poisson) * (1 - 2 * poisson));
  const double mu = block.modulus / (2 * (1 + poisson));
  constexpr std::array<std::array<int, 3>, 8> corner{
      {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}}};
  std::array<double, 3> h{};
  for (std::size_t i = 0; i < 3; ++i) h[i] = block.size[i] / block.elements[i];
  std::array<std::array<double, 24>, 24> stiffness{};
  for (const auto& gauss : corner) {
    std::array<std::array<double, 3>, 8> slope{};
    for (std::size_t a = 0; a < 8; ++a)
      for (std::size_t i = 0; i < 3; ++i) {
        slope[a][i] = (2 * corner[a][i] - 1) / h[i];
        for (std::size_t j = 0; j < 3; ++j)
          if (j != i) slope[a][i] *= 0.5 * (1 + (2 * corner[a][j] - 1) * (2 * gauss[j] - 1) / std::sqrt(3.0));
      }
    const double volume = h[0] * h[1] * h[2] / 8;
    for (std::size_t a = 0; a < 24; ++a)
      for (std::size_t b = 0; b < 24; ++b) {
        const auto &s = slope[a / 3], &t = slope[b / 3];
        const std::size_t i = a % 3, j = b % 3;
        double value = lambda * s[i] * t[j] + mu * s[j] * t[i];
        if (i == j) value += mu * (s[0] * t[0] + s[1] * t[1] + s[2] * t[2]);
        stiffness[a][b] += volume * value;
      }
  }
  return stiffness;
}

/// Adds the block's rows behind those of the matrix; returns its first row.
inline GlobalIndex add_block(SparseMatrix& matrix, const ElasticBlock& block) {
  const auto first = static_cast<GlobalIndex>(matrix.size());
  matrix.resize(matrix.size() + static_cast<std::size_t>(block.unknowns()));
  const auto stiffness = element_stiffness(block);
  for (int z = 0; z < block.elements[2]; ++z)
    for (int y = 0; y < block.elements[1]; ++y)
      for (int x = 0; x < block.elements[0]; ++x) {
        const std::array<GlobalIndex, 8> node{block.node(x, y, z),
                                              block.node(x + 1, y, z),
                                              block.node(x + 1, y + 1, z),
                                              block.node(x, y + 1, z),
                                              block.node(x, y, z + 1),
                                              block.node(x + 1, y, z + 1),
                                              block.node(x + 1, y + 1, z + 1),
                                              block.node(x, y + 1, z + 1)};
        for (std::size_t a = 0; a < 24; ++a)
          for (std::size_t b = 0; b < 24; ++b)
            matrix[static_cast<std::size_t>(first + 3 * node[a / 3]) + a % 3]
                  [first + 3 * node[b / 3] + static_cast<GlobalIndex>(b % 3)] += stiffness[a][b];
      }
  if (block.held)
    for (GlobalIndex k = first; k < first + 3 * block.node(0, 0, 1); ++k) {
      for (const auto& [column, value] : matrix[static_cast<std::size_t>(k)])
        if (column != k) matrix[static_cast<std::size_t>(column)].erase(k);
      matrix[static_cast<std::size_t>(k)] = {{k, 1.0}};
    }
  return first;
}

/// Rows with zeros on their diagonal that tie the top of one block to the bottom of another of the same layers.
inline void add_tie(SparseMatrix& matrix, const ElasticBlock& below, GlobalIndex below_first, GlobalIndex above_first) {
  const GlobalIndex top = below_first + 3 * below.node(0, 0, below.elements[2]);
  for (GlobalIndex k = 0; k < 3 * below.node(0, 0, 1); ++k) {
    const auto row = static_cast<GlobalIndex>(matrix.size());
    matrix.push_back({{top + k, 1.0}, {above_first + k, -1.0}});
    matrix[static_cast<std::size_t>(top + k)][row] = 1;
    matrix[static_cast<std::size_t>(above_first + k)][row] = -1;
  }
}

/// Two blocks of n x n x n/2 elements, the lower one held, tied together: indefinite, zeros on the diagonal.
inline SparseMatrix tied_blocks(int n) {
  SparseMatrix matrix;
  const ElasticBlock lower{.elements = {n, n, n / 2}, .held = true};
  const ElasticBlock upper{.elements = {n, n, n / 2}, .modulus = 3};
  const GlobalIndex first = add_block(matrix, lower), second = add_block(matrix, upper);
  add_tie(matrix, lower, first, second);
  return matrix;
}

inline SparseMatrix held_block(int n) {
  SparseMatrix matrix;
  add_block(matrix, {.elements = {n, n, n}, .held = true});
  return matrix;
}

inline comm::SparseRows rows_of(const SparseMatrix& matrix, const std::vector<GlobalIndex>& owned) {
  comm::SparseRows rows{.row = owned, .begin = {0}, .column = {}, .value = {}};
  for (const GlobalIndex row : owned) {
    for (const auto& [column, value] : matrix[static_cast<std::size_t>(row)]) {
      rows.column.push_back(column);
      rows.value.push_back(value);
    }
    rows.begin.push_back(static_cast<std::int64_t>(rows.column.size()));
  }
  return rows;
}

inline std::vector<GlobalIndex> all_rows(const SparseMatrix& matrix) {
  std::vector<GlobalIndex> rows;
  for (std::size_t i = 0; i < matrix.size(); ++i) rows.push_back(static_cast<GlobalIndex>(i));
  return rows;
}

/// A right-hand side without symmetries, of the rows that are named.
inline std::vector<double> load_of(const std::vector<GlobalIndex>& rows) {
  std::vector<double> load;
  for (const GlobalIndex row : rows) load.push_back(std::sin(1.0 + 0.7 * static_cast<double>(row)));
  return load;
}

}  // namespace brunt::test
