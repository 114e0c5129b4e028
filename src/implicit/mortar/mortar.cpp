// SPDX-License-Identifier: Apache-2.0
#include "implicit/mortar/mortar.hpp"

#include <algorithm>

#include "contact/mortar/active_set.hpp"
#include "contact/mortar/forces.hpp"
#include "contact/mortar/levers.hpp"
#include "contact/mortar/normals.hpp"
#include "contact/mortar/tractions.hpp"
#include "interface_rows.hpp"
#include "mortar_shares.hpp"
#include "self_sides.hpp"

namespace brunt::implicit {
namespace {

using contact::MortarPair;

/// Share of a penetration that a row recovers in a step, and its upper bound over a facet's edge. A node that slides
/// over a curved surface with the normals of t_{n+1} moves along a chord, which increases the penetration by travel^2
/// over twice the radius in each step: if half is recovered in a step, the penetration is bounded by the same amount.
/// Recovery of more than a twentieth of a facet at once would act as an impact.
constexpr double recovered = 0.5, most_recovered = 0.05;

void find_pressures(Interface& face, bool first) {
  if (face.pair.enforce == MortarPair::Enforce::penalty) {
    contact::penalty_pressures(face.iterate.rows, face.stiffness, {}, face.iterate.z);
    for (std::size_t row = 0; row < face.count(); ++row) face.iterate.active[row] = face.iterate.z[row] > 0 ? 1 : 0;
  } else {
    contact::choose_active(face.iterate.rows, face.iterate.z, face.stiffness, face.iterate.active, face.least.required);
  }
  face.start.first_iterate = first;
  for (std::size_t row = 0; first && row < face.count(); ++row)
    if (face.start.touches[row] != 0 && face.iterate.rows.covered[row] > 0) face.iterate.active[row] = 1;
}

void find_least_gaps(Interface& face, double recovery) {
  face.least.required.resize(face.count());
  face.least.by_start.resize(face.count());
  face.least.by_covered.resize(face.count());
  const double most = recovery * most_recovered * face.topology.edge;
  for (std::size_t row = 0; row < face.count(); ++row) {
    const double depth = std::max(0.0, -face.least.at_start[row]);
    const double share = face.pressed_before[row] != 0 ? recovery * recovered : 0.0;
    const bool all = share * depth <= most * face.iterate.rows.covered[row];
    face.least.by_start[row] = depth == 0 ? 0.0 : all ? 1 - share : 1.0;
    face.least.by_covered[row] = all ? 0.0 : most;
    face.least.required[row] =
        -face.least.by_start[row] * depth + face.least.by_covered[row] * face.iterate.rows.covered[row];
  }
}

/// Energy `of(face, row)` of the rows that keep their gap, summed over all rows of all ranks in their order.
template <class Energy>
double sum_over_rows(const MortarContact& contact, const Energy& of) {
  double sum = 0;
  std::vector<double> values;
  for (const Interface& face : contact.interfaces) {
    if (!face.keeps(contact)) continue;
    values.clear();
    for (std::size_t row = 0; row < face.count(); ++row) values.push_back(of(face, row));
    for (const double value : told_to_all(face, values, 1)) sum += value;
  }
  return sum;
}

/// Share of the recovery within the energy budget, estimated with the pressures of t_n.
double affordable(const MortarContact& contact) {
  if (!(contact.budget > 0)) return 0;
  const double needed = sum_over_rows(contact, [](const Interface& face, std::size_t row) {
    return std::max(0.0, face.iterate.z[row]) * recovered * std::max(0.0, -face.least.at_start[row]);
  });
  return needed > contact.budget ? contact.budget / needed : 1.0;
}

void find_tractions(const ContactNodes& nodes, Interface& face) {
  if (face.friction.coefficient > 0)
    contact::friction_tractions(face.iterate.rows, nodes.x, face.iterate.z, face.friction, face.history,
                                face.iterate.tractions, face.iterate.states);
  else
    contact::normal_tractions(face.iterate.rows, face.iterate.z, face.iterate.tractions);
}

/// Rows of a tie have the initial weights; their normals, for reports, and the levers of a gap rotate.
void find_tie(const MortarContact& contact, Interface& face) {
  const std::span<const Vec3> x = contact.nodes.x;
  contact::nodal_normals(face.surfaces, face.topology, x, face.iterate.rows.normals);
  contact::tie_levers(face.start.tie, face.surfaces, face.topology, contact.levers_from(), x, face.iterate.levers);
  for (std::size_t row = 0; row < face.count(); ++row) face.iterate.tractions[row] = Vec3(&face.iterate.z[3 * row]);
}

void find_rows(const MortarContact& contact, Iterate iterate, Interface& face) {
  const ContactNodes& nodes = contact.nodes;
  search(face, nodes.x);
  if (face.consistent()) {
    find_slopes_at(face, nodes.x, {});
    contact::NodeBlocks<Vec3> gradient;
    contact::gap_gradient(face.iterate.rows, face.iterate.slopes, gradient);
    contact::gap_levers(face.iterate.rows, gradient, face.iterate.gap_levers);
  } else {
    find_rows_at(face, nodes.x);
  }
  if (!face.keeps(contact)) return;
  contact::gaps_at(face.iterate.rows, nodes.x_before, face.least.at_start);
  if (iterate == Iterate::later) return;
  face.pressed_before.resize(face.count());
  for (std::size_t row = 0; row < face.count(); ++row) face.pressed_before[row] = face.iterate.z[row] > 0 ? 1 : 0;
}

/// Distributes the multipliers of this rank to its rows.
void take_multipliers(std::span<const double> own_z, MortarContact& contact) {
  for (Interface& face : contact.interfaces)
    if (face.multipliers() > 0) {
      std::ranges::copy(own_z.first(face.iterate.z.size()), face.iterate.z.begin());
      own_z = own_z.subspan(face.iterate.z.size());
    }
}

}  // namespace

void gather_contact(const comm::Communicator& ranks, const model::State& state, std::span<const double> own_z,
                    MortarContact& contact) {
  ContactNodes& nodes = contact.nodes;
  std::vector<double> local(3 * state.nodes.size()), here(3 * nodes.gid.size());
  for (std::size_t i = 0; i < state.nodes.size(); ++i)
    for (std::size_t c = 0; c < 3; ++c) local[3 * i + c] = state.nodes[i].x[c];
  nodes.gather.forward(local, here, 3);
  for (std::size_t k = 0; k < nodes.gid.size(); ++k) nodes.x[k] = Vec3(&here[3 * k]);
  if (masters_wear_out(ranks, contact)) tell_masters(ranks, contact);
  take_multipliers(own_z, contact);
}

void find_contact(const comm::Communicator& ranks, MortarContact& contact, Iterate iterate) {
  for (Interface& face : contact.interfaces)
    if (face.pair.tied)
      find_tie(contact, face);
    else
      find_rows(contact, iterate, face);
  if (iterate != Iterate::later) contact.recovery = affordable(contact);
  for (Interface& face : contact.interfaces) {
    if (face.pair.tied) continue;
    if (face.keeps(contact)) find_least_gaps(face, contact.recovery);
    find_pressures(face, iterate == Iterate::first_of_run);
    if (face.consistent() && face.multipliers() == 0)
      contact::add_penalty_levers(face.iterate.slopes, face.stiffness, face.iterate.z, face.iterate.gap_levers);
    find_tractions(contact.nodes, face);
  }
  sum_forces(ranks, contact);
}

void multiplier_residuals(const MortarContact& contact, std::span<double> residual) {
  std::size_t next = 0;
  std::vector<Vec3> ties;
  for (const Interface& face : contact.interfaces) {
    if (face.pair.tied) contact::tie_residuals(face.start.tie, face.surfaces, face.topology, contact.nodes.x, ties);
    for (std::size_t row = 0; row < face.count(); ++row) {
      const double area = 1 / face.topology.kappa[row];
      if (face.pair.tied) {
        const Vec3 given = face.start.tied[row] * (face.stiffness * area * ties[row]);
        const Vec3 redundant =
            area * (face.iterate.tractions[row] - face.start.tied[row] * face.iterate.tractions[row]);
        for (int c = 0; c < 3; ++c) residual[next++] = given[c] + redundant[c];
      } else if (face.multipliers() == 1) {
        const bool pressed = face.iterate.active[row] != 0;
        if (!pressed) {
          residual[next++] = area * face.iterate.z[row];
          continue;
        }
        const double fades = face.fades(row),
                     by_gap = face.stiffness * face.above(row) / face.iterate.rows.covered[row];
        residual[next++] = -area * ((1 - fades) * by_gap + fades * face.iterate.z[row]);
      }
    }
  }
}

void keep_contact(MortarContact& contact) {
  contact.z_before.clear();
  contact.traction_before.clear();
  contact.nodes.x_before = contact.nodes.x;
  const auto append = [](const std::vector<double>& values, std::vector<double>& to) {
    to.insert(to.end(), values.begin(), values.end());
  };
  for (Interface& face : contact.interfaces) {
    if (face.multipliers() > 0) append(told_to_all(face, face.iterate.z, face.multipliers()), contact.z_before);
    if (face.pair.tied || face.friction.coefficient == 0) continue;
    contact::keep_friction(face.iterate.rows, face.iterate.tractions, face.history);
    std::vector<double> tractions;
    for (const Vec3& traction : face.history.tractions)
      tractions.insert(tractions.end(), traction.data(), traction.data() + 3);
    append(told_to_all(face, tractions, 3), contact.traction_before);
  }
}

void restore_contact(const comm::Communicator& ranks, const model::State& state, MortarContact& contact) {
  if (!contact.any()) return;
  take_roles_before(contact);
  std::vector<double> own_z;
  for (const LocalIndex k : contact.own) own_z.push_back(nth(contact.z_before, k));
  gather_contact(ranks, state, own_z, contact);
  const std::vector<double> tractions = contact.traction_before;
  find_contact(ranks, contact, Iterate::first_of_step);
  keep_contact(contact);  // weights and normals follow from the positions
  choose_roles(ranks, contact);
  std::size_t first = 0;
  for (Interface& face : contact.interfaces) {
    if (face.pair.tied || face.friction.coefficient == 0) continue;
    for (std::size_t row = 0; row < face.count(); ++row)
      face.history.tractions[row] = Vec3(&tractions[first + 3 * static_cast<std::size_t>(face.numbering.place[row])]);
    first += 3 * face.numbering.rows_of_all;
  }
  contact.traction_before = tractions;
}

double given_in_step(const MortarContact& contact) {
  return sum_over_rows(contact, [](const Interface& face, std::size_t row) {
    return face.iterate.z[row] * (face.iterate.rows.gaps[row] - face.least.at_start[row]);
  });
}

}  // namespace brunt::implicit
