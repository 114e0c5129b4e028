// SPDX-License-Identifier: Apache-2.0
#include "contact/mortar/active_set.hpp"

namespace brunt::contact {

double layer_stiffness(double young, const MortarTopology& topology) {
  return young / topology.edge;
}

std::size_t choose_active(const MortarRows& rows, std::span<const double> z, double c,
                          std::vector<std::uint8_t>& active, std::span<const double> least) {
  std::size_t changed = 0;
  active.resize(z.size(), 0);
  for (std::size_t row = 0; row < z.size(); ++row) {
    const double above = rows.gaps[row] - (least.empty() ? 0.0 : least[row]);
    const bool pressed = rows.covered[row] > 0 && z[row] - c * above / rows.covered[row] > 0;
    changed += static_cast<std::size_t>(pressed != (active[row] != 0));
    active[row] = pressed ? 1 : 0;
  }
  return changed;
}

}  // namespace brunt::contact
