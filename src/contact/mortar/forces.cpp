// SPDX-License-Identifier: Apache-2.0
#include "brunt/contact/mortar/forces.hpp"

namespace brunt::contact {

void add_forces(const MortarRows& rows, std::span<const Vec3> tractions, std::span<Vec3> forces) {
  for (std::size_t row = 0; row < tractions.size(); ++row) {
    if (tractions[row].isZero(0)) continue;
    const auto index = static_cast<LocalIndex>(row);
    const std::span<const LocalIndex> nodes = rows.weights.nodes.row(index);
    const std::span<const double> weights = rows.weights.row(index);
    for (std::size_t k = 0; k < nodes.size(); ++k)
      forces[static_cast<std::size_t>(nodes[k])] += weights[k] * tractions[row];
  }
}

void force_directions(const MortarRows& rows, NodeBlocks<Vec3>& directions) {
  directions.nodes = rows.weights.nodes;
  directions.blocks.clear();
  for (std::size_t row = 0; row < rows.normals.size(); ++row)
    for (const double weight : rows.weights.row(static_cast<LocalIndex>(row)))
      directions.blocks.emplace_back(weight * rows.normals[row]);
}

void gap_gradient(const MortarRows& rows, const MortarSlopes& slopes, NodeBlocks<Vec3>& gradient) {
  gradient.clear();
  for (std::size_t row = 0; row < rows.normals.size(); ++row) {
    const auto index = static_cast<LocalIndex>(row);
    const std::span<const LocalIndex> nodes = slopes.gap_vectors.nodes.row(index);
    const std::size_t begin = gradient.blocks.size();
    for (std::size_t k = 0; k < nodes.size(); ++k) {
      gradient.nodes.values.push_back(nodes[k]);
      gradient.blocks.emplace_back(slopes.gap_vectors.row(index)[k].transpose() * rows.normals[row]);
    }
    const std::span<const LocalIndex> around = slopes.normals.nodes.row(index);
    for (std::size_t k = 0; k < around.size() && !nodes.empty(); ++k) {
      const Vec3 block = slopes.normals.row(index)[k].transpose() * rows.gap_vectors[row];
      std::size_t at = begin;
      while (at < gradient.blocks.size() && gradient.nodes.values[at] != around[k]) ++at;
      if (at == gradient.blocks.size()) {
        gradient.nodes.values.push_back(around[k]);
        gradient.blocks.push_back(block);
      } else {
        gradient.blocks[at] += block;
      }
    }
    gradient.nodes.close_row();
  }
}

void add_traction_slopes(const MortarRows& rows, const NodeBlocks<Mat3>& traction_slopes, Patches& patches) {
  for (LocalIndex row = 0; row < traction_slopes.nodes.rows(); ++row) {
    const std::span<const LocalIndex> nodes = rows.weights.nodes.row(row), by = traction_slopes.nodes.row(row);
    if (nodes.empty() || by.empty()) continue;
    Patch& patch = patches.next(row);
    patch.rows.assign(nodes.begin(), nodes.end());
    patch.columns.assign(by.begin(), by.end());
    patch.values.clear();
    for (const double weight : rows.weights.row(row))
      for (Eigen::Index i = 0; i < 3; ++i)
        for (const Mat3& slope : traction_slopes.row(row))
          for (Eigen::Index j = 0; j < 3; ++j) patch.values.push_back(weight * slope(i, j));
  }
}

}  // namespace brunt::contact
