// SPDX-License-Identifier: Apache-2.0
#include "implicit_probes.hpp"

#include "app/state/prepared.hpp"
#include "implicit/mortar/interface_forces.hpp"
#include "implicit/solver.hpp"
#include "implicit/static_forces.hpp"

namespace brunt::app {
namespace {

/// values: an InterfaceForce for each interface.
contact::TrackedTotals watched(const Prepared& run, const std::vector<double>& values, const std::string& part,
                               const std::string& other) {
  const implicit::MortarContact& contact = run.implicit->contact;
  constexpr auto width = static_cast<std::size_t>(implicit::interface_force_width);
  contact::TrackedTotals totals;
  for (std::size_t k = 0; k < contact.interfaces.size(); ++k) {
    const contact::MortarPair& pair = contact.interfaces[k].pair;
    const std::string& slave = nth(run.model.blocks, pair.slave).part;
    const std::string& master = nth(run.model.blocks, pair.master).part;
    const bool as_slave = slave == part && (other.empty() || master == other);
    const bool as_master = master == part && (other.empty() || slave == other);
    if (!as_slave && !as_master) continue;
    if (as_slave && as_master && other.empty()) continue;  // what a part does to itself is no force on it
    const double* impulse = &values[width * k];
    const double sign = as_slave && as_master ? 0 : as_slave ? 1 : -1;  // and has no resultant
    totals.impulse += sign * Vec3(impulse);
    totals.friction += sign * Vec3(impulse + 3);
    totals.normal_size += impulse[6];
    totals.friction_size += impulse[7];
  }
  return totals;
}

}  // namespace

contact::TrackedTotals watched_contact(const Prepared& run, const std::string& part, const std::string& other) {
  return watched(run, run.implicit->contact.impulses, part, other);
}

contact::TrackedTotals watched_contact_now(const Prepared& run, const std::string& part, const std::string& other) {
  return watched(run, run.implicit->contact.forces_before, part, other);
}

bool shows_static_states(const Prepared& run) {
  return run.implicit && implicit::is_static(*run.implicit);
}

Vec3 static_body_force(Prepared& run, std::size_t body, std::string_view field) {
  const model::Wrench acting = implicit::force_on_body(implicit_scene(run), *run.implicit, body);
  const model::Wrench support = implicit::support_of_body(run.model.bodies[body], acting);
  if (field == "force") return acting.force;
  if (field == "moment") return acting.moment;
  return field == "reaction" ? support.force : support.moment;
}

}  // namespace brunt::app
