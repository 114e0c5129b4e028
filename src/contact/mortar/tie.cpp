// SPDX-License-Identifier: Apache-2.0
#include "brunt/contact/mortar/tie.hpp"

#include "add_block.hpp"
#include "turn.hpp"

namespace brunt::contact {

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
