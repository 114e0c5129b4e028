// SPDX-License-Identifier: Apache-2.0
#include "contact/mortar/levers.hpp"

#include <algorithm>

#include "add_block.hpp"

namespace brunt::contact {

namespace {

using PatchBlock = Eigen::Map<Eigen::Matrix<double, 3, 3, Eigen::RowMajor>, 0, Eigen::OuterStride<>>;

PatchBlock block_of(Patch& patch, std::size_t row, std::size_t column) {
  const std::size_t width = 3 * patch.columns.size();
  return PatchBlock(patch.values.data() + 3 * row * width + 3 * column,
                    Eigen::OuterStride<>(static_cast<Eigen::Index>(width)));
}

std::size_t place_in(std::span<const LocalIndex> nodes, LocalIndex node) {
  return static_cast<std::size_t>(std::ranges::find(nodes, node) - nodes.begin());
}

/// The nodes of a row: of its weights, then those that only its normal depends on.
void lay_nodes(const MortarSlopes& slopes, LocalIndex row, Patch& patch) {
  const std::span<const LocalIndex> of_gap = slopes.gap_vectors.nodes.row(row);
  patch.rows.assign(of_gap.begin(), of_gap.end());
  for (const LocalIndex node : slopes.normals.nodes.row(row))
    if (std::ranges::find(patch.rows, node) == patch.rows.end()) patch.rows.push_back(node);
  patch.columns = patch.rows;
  patch.values.assign(9 * patch.rows.size() * patch.rows.size(), 0.0);
}

}  // namespace

void gap_levers(const MortarRows& rows, const NodeBlocks<Vec3>& gradient, NodeBlocks<Vec3>& levers) {
  levers = gradient;
  for (std::size_t row = 0; row < rows.normals.size(); ++row) {
    const auto first = static_cast<std::size_t>(levers.nodes.offsets[row]);
    const std::span<const double> weights = rows.weights.row(static_cast<LocalIndex>(row));
    for (std::size_t k = 0; k < weights.size(); ++k)  // the gradient begins with the nodes of the weights
      levers.blocks[first + k] -= weights[k] * rows.normals[row];
  }
}

void add_penalty_levers(const MortarSlopes& slopes, double stiffness, std::span<const double> z,
                        NodeBlocks<Vec3>& levers) {
  for (std::size_t row = 0; row < z.size(); ++row) {
    if (z[row] == 0) continue;
    const auto index = static_cast<LocalIndex>(row);
    const auto first = static_cast<std::size_t>(levers.nodes.offsets[row]);
    const std::span<const Vec3> area = slopes.covered.row(index);
    for (std::size_t k = 0; k < area.size(); ++k) levers.blocks[first + k] += 0.5 * z[row] / stiffness * area[k];
  }
}

void lever_patches(const MortarRows& rows, const MortarSlopes& slopes, std::span<const double> z, Patches& patches) {
  patches.clear();
  for (std::size_t row = 0; row < z.size(); ++row) {
    const auto index = static_cast<LocalIndex>(row);
    const std::span<const Mat3> of_gap = slopes.gap_vectors.row(index), of_normal = slopes.normals.row(index);
    if (z[row] == 0 || of_gap.empty()) continue;
    Patch& patch = patches.next(index);
    lay_nodes(slopes, index, patch);
    const std::span<const double> weights = rows.weights.row(index);
    for (std::size_t b = 0; b < of_normal.size(); ++b) {
      const std::size_t at = place_in(patch.rows, slopes.normals.nodes.row(index)[b]);
      for (std::size_t a = 0; a < of_gap.size(); ++a) {
        block_of(patch, a, at) += z[row] * (of_gap[a] - weights[a] * Mat3::Identity()).transpose() * of_normal[b];
        block_of(patch, at, a) += z[row] * of_normal[b].transpose() * of_gap[a];
      }
    }
  }
}

void add_penalty_lever_patches(const MortarRows& rows, const MortarSlopes& slopes, const NodeBlocks<Vec3>& gradient,
                               const NodeBlocks<Vec3>& levers, double stiffness, std::span<const double> z,
                               Patches& patches) {
  for (std::size_t p = 0; p < patches.count; ++p) {
    const LocalIndex index = patches.source[p];
    const auto row = static_cast<std::size_t>(index);
    Patch& patch = patches.patch[p];
    const std::span<const Vec3> area = slopes.covered.row(index);
    for (std::size_t b = 0; b < patch.columns.size(); ++b) {
      Vec3 by = gradient.row(index)[b];  // dz/dx = - k/c (h + z/k dc/dx)
      if (b < area.size()) by += z[row] / stiffness * area[b];
      for (std::size_t a = 0; a < patch.rows.size(); ++a) {
        Vec3 force = levers.row(index)[a];
        if (a < area.size()) force += 0.5 * z[row] / stiffness * area[a];
        block_of(patch, a, b) -= stiffness / rows.covered[row] * force * by.transpose();
      }
    }
  }
}

}  // namespace brunt::contact
