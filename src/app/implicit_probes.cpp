// SPDX-License-Identifier: Apache-2.0
#include "implicit_probes.hpp"

#include "brunt/implicit/interface_forces.hpp"
#include "brunt/implicit/solver.hpp"

namespace brunt::app {

contact::TrackedTotals watched_contact(const Prepared& run, const std::string& part, const std::string& other) {
  const implicit::MortarContact& contact = run.implicit->contact;
  constexpr auto width = static_cast<std::size_t>(implicit::interface_force_width);
  contact::TrackedTotals totals;
  for (std::size_t k = 0; k < contact.interfaces.size(); ++k) {
    const contact::MortarPair& pair = contact.interfaces[k].pair;
    const std::string& slave = run.model.blocks[static_cast<std::size_t>(pair.slave)].part;
    const std::string& master = run.model.blocks[static_cast<std::size_t>(pair.master)].part;
    const bool as_slave = slave == part && (other.empty() || master == other);
    const bool as_master = master == part && (other.empty() || slave == other);
    if (!as_slave && !as_master) continue;
    const double* impulse = &contact.impulses[width * k];
    const double sign = as_slave ? 1 : -1;
    totals.impulse += sign * Vec3(impulse);
    totals.friction += sign * Vec3(impulse + 3);
    totals.normal_size += impulse[6];
    totals.friction_size += impulse[7];
  }
  return totals;
}

}  // namespace brunt::app
