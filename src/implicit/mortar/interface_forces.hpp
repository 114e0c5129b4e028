// SPDX-License-Identifier: Apache-2.0
// Resultant forces of each mortar interface on its slave: for probes.
#pragma once
#include "core/types.hpp"
#include "implicit/mortar/mortar.hpp"

namespace brunt::implicit {

/// Of one interface on its slave; the force on the master is the opposite. Saved as doubles.
struct InterfaceForce {
  double all[3] = {0, 0, 0};                  ///< [force]; as impulse [momentum]
  double friction[3] = {0, 0, 0};             ///< the tangential part of it
  double normal_size = 0, friction_size = 0;  ///< sums of the magnitudes of the rows' parts
};
constexpr int interface_force_width = sizeof(InterfaceForce) / sizeof(double);

/// At the accepted iterate, in the order of the rows of all ranks. Collective.
InterfaceForce force_on_slave(const Interface& face);

/// Adds the impulses of a step: the share of_impulse of the current forces and the rest of those at t_n, which are then
/// replaced by
/// the current ones. Collective.
void book_interfaces(double dt, double of_impulse, MortarContact& contact);

}  // namespace brunt::implicit
