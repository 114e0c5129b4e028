// SPDX-License-Identifier: Apache-2.0
#include "contact/mortar/forces.hpp"

#include "add_block.hpp"

namespace brunt::contact {

void add_forces(const MortarRows& rows, std::span<const Vec3> tractions, std::span<Vec3> forces) {
  for (std::size_t row = 0; row < tractions.size(); ++row) {
    if (tractions[row].isZero(0)) continue;
    const auto index = static_cast<LocalIndex>(row);
    const std::span<const LocalIndex> nodes = rows.weights.nodes.row(index);
    const std::span<const double> weights = rows.weights.row(index);
    for (std::size_t k = 0; k < nodes.size(); ++k) nth(forces, nodes[k]) += weights[k] * tractions[row];
  }
}

void pressure_columns(const MortarRows& rows, std::span<const Vec3> by_pressure, NodeBlocks<Vec3>& columns) {
  columns.nodes = rows.weights.nodes;
  columns.blocks.clear();
  for (std::size_t row = 0; row < by_pressure.size(); ++row)
    for (const double weight : rows.weights.row(static_cast<LocalIndex>(row)))
      columns.blocks.emplace_back(weight * by_pressure[row]);
}

namespace {

/// d(normal_A . V_A)/dx, for vectors with the derivatives `of_vectors`.
template <class VectorOf>
void normal_part_gradient(const MortarRows& rows, const MortarSlopes& slopes, const NodeBlocks<Mat3>& of_vectors,
                          const VectorOf& vector, NodeBlocks<Vec3>& gradient) {
  gradient.clear();
  for (std::size_t row = 0; row < rows.normals.size(); ++row) {
    const auto index = static_cast<LocalIndex>(row);
    const std::span<const LocalIndex> nodes = of_vectors.nodes.row(index);
    for (std::size_t k = 0; k < nodes.size(); ++k) {  // each node once: entries need no sum
      gradient.nodes.values.push_back(nodes[k]);
      gradient.blocks.emplace_back(of_vectors.row(index)[k].transpose() * rows.normals[row]);
    }
    const std::span<const LocalIndex> around = slopes.normals.nodes.row(index);
    const Vec3 of_row = nodes.empty() ? Vec3(Vec3::Zero()) : vector(row);
    for (std::size_t k = 0; k < around.size() && !nodes.empty(); ++k)
      add_block(gradient, around[k], Vec3(slopes.normals.row(index)[k].transpose() * of_row));
    gradient.nodes.close_row();
  }
}

}  // namespace

void gap_gradient(const MortarRows& rows, const MortarSlopes& slopes, NodeBlocks<Vec3>& gradient) {
  normal_part_gradient(
      rows, slopes, slopes.gap_vectors, [&](std::size_t row) { return rows.gap_vectors[row]; }, gradient);
}

void gaps_at(const MortarRows& rows, std::span<const Vec3> y, std::vector<double>& gaps) {
  gaps.assign(rows.gaps.size(), 0);
  for (std::size_t row = 0; row < gaps.size(); ++row)
    gaps[row] = rows.normals[row].dot(weighted_sum(rows.weights, static_cast<LocalIndex>(row), y));
}

void gaps_at_gradient(const MortarRows& rows, const MortarSlopes& slopes, std::span<const Vec3> y,
                      NodeBlocks<Vec3>& gradient) {
  normal_part_gradient(
      rows, slopes, slopes.of_fixed,
      [&](std::size_t row) { return weighted_sum(rows.weights, static_cast<LocalIndex>(row), y); }, gradient);
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
