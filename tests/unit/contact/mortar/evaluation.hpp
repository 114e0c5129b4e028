// SPDX-License-Identifier: Apache-2.0
// Rows of two surfaces, matrices put together from their parts, and their comparison with central differences.
#pragma once
#include <algorithm>
#include <cmath>
#include <vector>

#include "two_surfaces.hpp"

namespace brunt::test {

using contact::MortarRows;
using contact::MortarScratchPointer;
using contact::MortarSlopes;
using contact::MortarTopology;
using contact::NodeBlocks;
using contact::Patch;
using contact::Patches;

struct Evaluation {
  MortarTopology topology;
  MortarRows rows;
  MortarSlopes slopes;
  MortarScratchPointer scratch = contact::make_mortar_scratch();

  explicit Evaluation(const TwoSurfaces& two) : topology(contact::make_topology(two.surfaces, two.x)) {
    mortar_rows(two.surfaces, topology, two.candidates, two.x, *scratch, rows);
  }
  void move(const TwoSurfaces& two, std::span<const Vec3> x) {
    mortar_rows(two.surfaces, topology, two.candidates, x, *scratch, rows);
  }
  void differentiate(const TwoSurfaces& two, std::span<const Vec3> tractions) {
    mortar_rows_and_slopes(two.surfaces, topology, two.candidates, two.x, tractions, *scratch, rows, slopes);
  }
};

inline std::vector<double> some_pressures(std::size_t rows) {
  std::vector<double> z;
  for (std::size_t row = 0; row < rows; ++row) z.push_back(row % 5 == 4 ? 0 : 0.5 + 0.1 * static_cast<double>(row % 7));
  return z;
}

/// Dense matrix of the patches: entry (3 K + i, 3 L + j).
inline std::vector<double> assembled(const Patches& patches, std::size_t nodes) {
  std::vector<double> matrix(9 * nodes * nodes, 0);
  for (std::size_t p = 0; p < patches.count; ++p) {
    const Patch& patch = patches.patch[p];
    const std::size_t columns = 3 * patch.columns.size();
    for (std::size_t r = 0; r < 3 * patch.rows.size(); ++r)
      for (std::size_t c = 0; c < columns; ++c)
        matrix[(3 * static_cast<std::size_t>(patch.rows[r / 3]) + r % 3) * 3 * nodes +
               3 * static_cast<std::size_t>(patch.columns[c / 3]) + c % 3] += patch.values[r * columns + c];
  }
  return matrix;
}

/// Dense matrix of rows of vectors (one line a row) or of blocks (three lines a row), by all coordinates.
inline std::vector<double> assembled(const NodeBlocks<Vec3>& rows, std::size_t nodes) {
  const auto count = static_cast<std::size_t>(rows.nodes.rows());
  std::vector<double> matrix(count * 3 * nodes, 0);
  for (std::size_t row = 0; row < count; ++row) {
    const auto of_row = rows.nodes.row(static_cast<LocalIndex>(row));
    for (std::size_t k = 0; k < of_row.size(); ++k)
      for (std::size_t j = 0; j < 3; ++j)
        matrix[row * 3 * nodes + 3 * static_cast<std::size_t>(of_row[k]) + j] +=
            rows.row(static_cast<LocalIndex>(row))[k][static_cast<Eigen::Index>(j)];
  }
  return matrix;
}

inline std::vector<double> assembled(const NodeBlocks<Mat3>& rows, std::size_t nodes) {
  const auto count = static_cast<std::size_t>(rows.nodes.rows());
  std::vector<double> matrix(count * 9 * nodes, 0);
  for (std::size_t row = 0; row < count; ++row) {
    const auto of_row = rows.nodes.row(static_cast<LocalIndex>(row));
    for (std::size_t k = 0; k < of_row.size(); ++k)
      for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 3; ++j)
          matrix[(3 * row + i) * 3 * nodes + 3 * static_cast<std::size_t>(of_row[k]) + j] +=
              rows.row(static_cast<LocalIndex>(row))[k](static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j));
  }
  return matrix;
}

inline std::vector<double> flat(const std::vector<Vec3>& vectors) {
  std::vector<double> all;
  for (const Vec3& v : vectors) all.insert(all.end(), {v[0], v[1], v[2]});
  return all;
}

/// Largest difference of a matrix (lines by all coordinates) from central differences of `function` with steps of 1e-6,
/// over the largest entry.
template <class Function>
double difference(const std::vector<double>& matrix, const std::vector<Vec3>& at, const Function& function) {
  const double step = 1e-6;
  double largest = 0, worst = 0;
  std::vector<Vec3> x = at;
  for (std::size_t direction = 0; direction < 3 * at.size(); ++direction) {
    double& moving = x[direction / 3][static_cast<Eigen::Index>(direction % 3)];
    const double here = moving;
    moving = here + step;
    const std::vector<double> plus = function(x);
    moving = here - step;
    const std::vector<double> minus = function(x);
    moving = here;
    for (std::size_t line = 0; line < plus.size(); ++line) {
      const double slope = (plus[line] - minus[line]) / (2 * step);
      largest = std::max(largest, std::abs(slope));
      worst = std::max(worst, std::abs(slope - matrix[line * 3 * at.size() + direction]));
    }
  }
  return worst / largest;
}

}  // namespace brunt::test
