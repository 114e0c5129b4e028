// SPDX-License-Identifier: Apache-2.0
#include "contact/mortar/tractions.hpp"

#include <algorithm>

#include "add_block.hpp"

namespace brunt::contact {

void normal_tractions(const MortarRows& rows, std::span<const double> z, std::vector<Vec3>& tractions) {
  tractions.clear();
  for (std::size_t row = 0; row < z.size(); ++row) tractions.emplace_back(z[row] * rows.normals[row]);
}

void normal_traction_slopes(const MortarRows& rows, const MortarSlopes& slopes, std::span<const double> z,
                            TractionSlopes& out) {
  out.by_position.clear();
  out.by_pressure = rows.normals;
  for (std::size_t row = 0; row < z.size(); ++row) {
    if (z[row] != 0) add_row(out.by_position, z[row] * Mat3::Identity(), slopes.normals, static_cast<LocalIndex>(row));
    out.by_position.nodes.close_row();
  }
}

void penalty_pressures(const MortarRows& rows, double stiffness, std::span<const double> base, std::vector<double>& z) {
  z.assign(rows.gaps.size(), 0);
  for (std::size_t row = 0; row < z.size(); ++row)
    if (rows.covered[row] > 0)
      z[row] = std::max(0.0, (base.empty() ? 0 : base[row]) - stiffness * rows.gaps[row] / rows.covered[row]);
}

void add_penalty_slopes(const MortarRows& rows, const NodeBlocks<Vec3>& gradient, const MortarSlopes& of_rows,
                        double stiffness, std::span<const std::uint8_t> pressed, TractionSlopes& slopes) {
  NodeBlocks<Mat3> sum;
  for (std::size_t row = 0; row < pressed.size(); ++row) {
    const auto index = static_cast<LocalIndex>(row);
    add_row(sum, Mat3::Identity(), slopes.by_position, index);
    if (pressed[row] != 0 && rows.covered[row] > 0) {
      const double rate = -stiffness / rows.covered[row], by_covered = -rate * rows.gaps[row] / rows.covered[row];
      const std::span<const LocalIndex> nodes = gradient.nodes.row(index), around = of_rows.covered.nodes.row(index);
      for (std::size_t k = 0; k < nodes.size(); ++k)
        add_block(sum, nodes[k], Mat3(rate * slopes.by_pressure[row] * gradient.row(index)[k].transpose()));
      for (std::size_t k = 0; k < around.size(); ++k)
        add_block(sum, around[k],
                  Mat3(by_covered * slopes.by_pressure[row] * of_rows.covered.row(index)[k].transpose()));
    }
    sum.nodes.close_row();
  }
  slopes.by_position = std::move(sum);
}

}  // namespace brunt::contact
