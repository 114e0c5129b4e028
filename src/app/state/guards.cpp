// SPDX-License-Identifier: Apache-2.0
#include "guards.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>

namespace brunt::app {

void observe(const time::Ledger& ledger, Extremes& seen) {
  const Vec3 own_momentum = ledger.momentum - ledger.impulse_given;
  if (seen.begun == 0) {
    seen.begun = 1;
    seen.start_total = ledger.total();
    for (int c = 0; c < 3; ++c) seen.start_momentum[c] = own_momentum[c];
    // The initial kinetic energy may vanish within the first step, if contact or a support stops the bodies at once:
    // the product of the velocities on both sides of t = 0 is then zero, but the total includes the energy taken.
    seen.largest_energy = seen.largest_bodies = std::abs(seen.start_total);
    seen.momentum_scale = own_momentum.norm();
  }
  const double bodies = ledger.kinetic + ledger.internal;
  seen.largest_bodies = std::max(seen.largest_bodies, bodies);
  seen.largest_energy = std::max({seen.largest_energy, bodies, std::abs(ledger.external)});
  seen.largest_contact = std::max(seen.largest_contact, ledger.contact_totals.contact_work);
  seen.largest_stored = std::max(seen.largest_stored, ledger.contact_totals.stored);
  seen.largest_internal = std::max(seen.largest_internal, ledger.internal);
  seen.momentum_scale = std::max(seen.momentum_scale, ledger.momentum_scale);
  seen.largest_error = std::max(seen.largest_error, std::abs(ledger.total() - seen.start_total));
  const Vec3 start(seen.start_momentum[0], seen.start_momentum[1], seen.start_momentum[2]);
  if (seen.momentum_scale > 0)
    seen.momentum_error = std::max(seen.momentum_error, (own_momentum - start).norm() / seen.momentum_scale);
}

double energy_change(const time::Ledger& ledger, const Extremes& seen) {
  return seen.largest_energy > 0 ? (ledger.total() - seen.start_total) / seen.largest_energy : 0.0;
}

double error_ratio(const Extremes& seen) {
  return seen.largest_energy > 0 ? seen.largest_error / seen.largest_energy : 0.0;
}

double rounding_energy(double mass, double extent, double edge, double dt) {
  constexpr double of_contact = 1e-12;
  if (!(dt > 0)) return 0;
  const double speed = std::max(4 * std::numeric_limits<double>::epsilon() * extent, of_contact * edge) / dt;
  return mass * speed * speed;
}

double settling_energy(double mass, double gravity, double dt, double tolerance, double recovery) {
  return mass * gravity * gravity * dt * dt * tolerance / recovery;
}

std::string energy_growth(const time::Ledger& ledger, const Extremes& seen, bool recovered, double rounding,
                          const std::string& among_rigid, const scene::Guards& limits) {
  // A moving wall supplies energy, and so does contact between initially overlapping bodies. At the first instant the
  // whole energy may be rounding of either sign.
  const double parted = recovered ? std::max(-ledger.contact, 0.0) : 0.0;
  const double given = std::max(seen.start_total, 0.0) + std::max(ledger.external, 0.0) + std::max(-ledger.walls, 0.0) +
                       std::max(-ledger.driven, 0.0) + parted;
  const double scale = std::max({seen.largest_energy, std::abs(ledger.internal), std::abs(seen.start_total)});
  if (std::isfinite(ledger.total()) && ledger.kinetic <= limits.kinetic * given + 1e-3 * scale + rounding) return {};
  return fmt::format(
      "kinetic energy {:g}, supplied energy {:g}; {}", ledger.kinetic, given,
      among_rigid.empty() ? "the step may be too large for the materials, or elements too distorted" : among_rigid);
}

namespace {

using Energies = std::array<double, guarded_columns>;

/// In the order of Fault: what is wrong, of either sign.
Energies faults_of(const time::Ledger& ledger, const Extremes& seen, Gives gives) {
  const double returned = seen.largest_contact - std::max(ledger.contact_totals.contact_work, 0.0);
  return {ledger.total() - seen.start_total,
          std::min(ledger.hourglass, 0.0),
          std::min(ledger.bulk, 0.0),
          std::min(ledger.damping, 0.0),
          std::min(ledger.friction - ledger.ties, 0.0),
          std::min(ledger.internal, 0.0),
          gives == Gives::parting ? 0.0 : std::min(ledger.contact, 0.0),
          gives == Gives::nothing ? std::min(seen.largest_stored - returned, 0.0) : 0.0};
}

std::vector<Finding> findings_of(std::span<const double, guarded_columns> energy, double scale,
                                 const scene::Guards& limits) {
  std::vector<Finding> findings;
  for (std::size_t k = 0; k < energy.size(); ++k)
    if (const double share = scale > 0 ? std::abs(energy[k]) / scale : 0.0; share > limits.energy_warning)
      findings.push_back({static_cast<Fault>(k), energy[k], share, share > limits.energy_stop});
  return findings;
}

}  // namespace

std::vector<Finding> judge(const time::Ledger& ledger, const Extremes& seen, double rounding, Gives gives,
                           const scene::Guards& limits) {
  return findings_of(faults_of(ledger, seen, gives), std::max(seen.largest_energy, 10 * rounding), limits);
}

void note_worst(const time::Ledger& ledger, Gives gives, double time, Extremes& seen) {
  const Energies energy = faults_of(ledger, seen, gives);
  for (std::size_t k = 1; k < energy.size(); ++k) {
    if (!(energy[k] < seen.worst[k])) continue;
    seen.worst[k] = energy[k];
    seen.worst_time[k] = time;
  }
}

std::vector<Finding> judge_whole(const Extremes& seen, double rounding, const scene::Guards& limits) {
  return findings_of(seen.worst, std::max(seen.largest_energy, 10 * rounding), limits);
}

std::string text_of(const Finding& finding, double time, const char* of) {
  if (finding.fault == Fault::balance)
    return fmt::format("the error of the energy balance is {:.3g} at t = {:g}, {:.2g} % of {}", finding.energy, time,
                       100 * finding.share, of);
  if (finding.fault == Fault::returned)
    return fmt::format(
        "contact has given back {:.3g} of the energy that it had dissipated, by t = {:g}, {:.2g} % of {}, but must "
        "only take energy",
        -finding.energy, time, 100 * finding.share, of);
  constexpr std::array names{"",
                             "hourglass energy",
                             "energy of bulk viscosity",
                             "energy of damping",
                             "energy of sliding friction",
                             "internal energy",
                             "energy dissipated by contact"};
  return fmt::format("{} is {:.3g} at t = {:g}, {:.2g} % of {}, but must not be negative", nth(names, finding.fault),
                     finding.energy, time, 100 * finding.share, of);
}

std::string likely_cause(Fault fault, const std::string& among_rigid) {
  if (!among_rigid.empty()) return "likely cause: " + among_rigid;
  switch (fault) {
    case Fault::balance:
      return "likely cause: very large velocities or stresses of a few nodes or elements; the step may be too large "
             "for the materials (see run.cfl), or elements too distorted";
    case Fault::hourglass:
      return "likely cause: the element has deformed so much that its hourglass stiffness differs from that during "
             "loading. Use element: hex8_full or hex8_bbar there, or smaller elements";
    case Fault::bulk:
      return "likely cause: the element is folded or nearly flat. Use smaller elements there, or element: hex8_full";
    case Fault::damping:
      return "likely cause: velocities that change their sign in every step; use a smaller run.cfl";
    case Fault::friction:
      return "likely cause: sticking nodes are returned against their load where the faces of the master are much "
             "larger than their own, or rotate fast. Use smaller elements there, or passes: two";
    case Fault::internal:
      break;  // depends on the laws: cause_of_given_work
    case Fault::contact:
    case Fault::returned:
      return "likely cause: nodes are pushed out of faces that they never crossed, for example in bodies that are "
             "compressed to a small part of their thickness and touch themselves (use self: false in contact), or in "
             "folded elements";
  }
  return {};
}

double taken_by_parted(const time::Ledger& ledger, const Extremes& seen) {
  const contact::ContactTotals& contact = ledger.contact_totals;
  const bool parted = contact.push > 0 && contact.touching == 0;
  return parted && seen.largest_bodies > 0 ? ledger.contact / seen.largest_bodies : 0.0;
}

double angular_error(const time::Ledger& ledger, const Extremes& seen, double extent) {
  // of bodies at rest the momentum is nothing, while their impulses sum up with time, and with them what rounding
  // leaves
  const double turned = std::max(seen.momentum_scale, ledger.contact_totals.push) * extent;
  return turned > 0 ? ledger.contact_totals.spin.norm() / turned : 0.0;
}

}  // namespace brunt::app
