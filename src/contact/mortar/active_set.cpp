// SPDX-License-Identifier: Apache-2.0
#include "brunt/contact/mortar/active_set.hpp"

namespace brunt::contact {

void normal_tractions(const MortarRows& rows, std::span<const double> z, std::vector<Vec3>& tractions) {
  tractions.clear();
  for (std::size_t row = 0; row < z.size(); ++row) tractions.emplace_back(z[row] * rows.normals[row]);
}

void normal_traction_slopes(const MortarSlopes& slopes, std::span<const double> z, NodeBlocks<Mat3>& traction_slopes) {
  traction_slopes.clear();
  for (std::size_t row = 0; row < z.size(); ++row) {
    const auto index = static_cast<LocalIndex>(row);
    const std::span<const LocalIndex> nodes = slopes.normals.nodes.row(index);
    for (std::size_t k = 0; k < nodes.size() && z[row] != 0; ++k) {
      traction_slopes.nodes.values.push_back(nodes[k]);
      traction_slopes.blocks.emplace_back(z[row] * slopes.normals.row(index)[k]);
    }
    traction_slopes.nodes.close_row();
  }
}

double active_set_scale(double young, const MortarTopology& topology) {
  return young / topology.edge;
}

std::size_t choose_active(const MortarRows& rows, const MortarTopology& topology, std::span<const double> z,
                          double scale, std::vector<std::uint8_t>& active) {
  std::size_t changed = 0;
  active.resize(z.size(), 0);
  for (std::size_t row = 0; row < z.size(); ++row) {
    const bool pressed = rows.covered[row] > 0 && z[row] - scale * rows.normalised_gap(topology, row) > 0;
    changed += static_cast<std::size_t>(pressed != (active[row] != 0));
    active[row] = pressed ? 1 : 0;
  }
  return changed;
}

}  // namespace brunt::contact
