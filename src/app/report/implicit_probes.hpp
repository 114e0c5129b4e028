// SPDX-License-Identifier: Apache-2.0
// What probes of contact see in implicit runs.
#pragma once
#include <string>
#include <string_view>

#include "app/state/prepared.hpp"
#include "contact/contact_ledger.hpp"

namespace brunt::app {

/// Impulses that the other part (empty: all others) has exerted on `part` through mortar interfaces since t = 0.
contact::TrackedTotals watched_contact(const Prepared& run, const std::string& part, const std::string& other);
/// Likewise the forces at t_n.
contact::TrackedTotals watched_contact_now(const Prepared& run, const std::string& part, const std::string& other);

/// Whether columns of forces are those of the state at t_n, and no body has momentum.
bool shows_static_states(const Prepared& run);

/// At t_n, of a rigid body: fields as of body_impulse. Collective.
Vec3 static_body_force(Prepared& run, std::size_t body, std::string_view field);

}  // namespace brunt::app
