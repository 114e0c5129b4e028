// SPDX-License-Identifier: Apache-2.0
#include "brunt/implicit/mortar.hpp"

#include <algorithm>

#include "brunt/contact/mortar/active_set.hpp"
#include "brunt/contact/mortar/forces.hpp"
#include "brunt/contact/mortar/normals.hpp"
#include "brunt/contact/mortar/tractions.hpp"

namespace brunt::implicit {
namespace {

using contact::MortarPair;

/// Share of a penetration that a row recovers in a step, and the most of it over a facet's edge. What slides over a
/// curved surface with the normals of t_{n+1} goes along a chord, deeper by travel^2 over twice the radius in a step:
/// half of it a step leaves as much. More than a twentieth of a facet at once would be a blow.
constexpr double recovered = 0.5, most_recovered = 0.05;

/// Pairs of facets nearer than the capture distance at these positions: both trees enlarged by half of it.
void search(Interface& face, std::span<const Vec3> x) {
  PairSearch& search = face.search;
  constexpr double worn_out = 2;  // trees are built anew where a pair takes so many times the tests it took at first
  const bool anew = search.slave.facets() == 0 ||
                    (search.counts.pairs > 0 && search.counts.tests_per_pair() > worn_out * search.built_with);
  if (anew) {
    contact::build(search.slave, face.surfaces.slave, x);
    contact::build(search.master, face.surfaces.master, x);
  }
  const contact::Enlargement half = contact::by_distance(0.5 * face.surfaces.capture);
  contact::refit(search.slave, x, half);
  contact::refit(search.master, x, half);
  search.counts = contact::find_pairs(search.slave, search.master, search.scratch, search.pairs);
  if (anew) search.built_with = search.counts.tests_per_pair();
  search.candidates.clear();
  auto pair = search.pairs.begin();
  for (LocalIndex facet = 0; facet < static_cast<LocalIndex>(face.surfaces.slave.size()); ++facet) {
    for (; pair != search.pairs.end() && pair->slave == facet; ++pair) search.candidates.values.push_back(pair->master);
    search.candidates.close_row();
  }
}

void find_pressures(Interface& face, bool first) {
  if (face.pair.enforce == MortarPair::Enforce::penalty) {
    contact::penalty_pressures(face.rows, face.stiffness, {}, face.z);
    for (std::size_t row = 0; row < face.count(); ++row) face.active[row] = face.z[row] > 0 ? 1 : 0;
  } else {
    contact::choose_active(face.rows, face.z, face.stiffness, face.active, face.least_gaps);
  }
  face.at_start = first;
  for (std::size_t row = 0; first && row < face.count(); ++row)
    if (face.touches[row] != 0 && face.rows.covered[row] > 0) face.active[row] = 1;
}

void find_least_gaps(Interface& face, double recovery) {
  face.least_gaps.resize(face.count());
  face.least_by_start.resize(face.count());
  face.least_by_covered.resize(face.count());
  const double most = recovery * most_recovered * face.topology.edge;
  for (std::size_t row = 0; row < face.count(); ++row) {
    const double depth = std::max(0.0, -face.start_gaps[row]);
    const double share = face.pressed_before[row] != 0 ? recovery * recovered : 0.0;
    const bool all = share * depth <= most * face.rows.covered[row];
    face.least_by_start[row] = depth == 0 ? 0.0 : all ? 1 - share : 1.0;
    face.least_by_covered[row] = all ? 0.0 : most;
    face.least_gaps[row] = -face.least_by_start[row] * depth + face.least_by_covered[row] * face.rows.covered[row];
  }
}

/// Share of the recovery that the budget pays for, by the pressures of t_n.
double affordable(const MortarContact& contact) {
  if (!(contact.budget > 0)) return 0;
  double needed = 0;
  for (const Interface& face : contact.interfaces)
    for (std::size_t row = 0; row < face.start_gaps.size(); ++row)
      needed += std::max(0.0, face.z[row]) * recovered * std::max(0.0, -face.start_gaps[row]);
  return needed > contact.budget ? contact.budget / needed : 1.0;
}

void find_tractions(const ContactNodes& nodes, Interface& face) {
  if (face.friction.coefficient > 0)
    contact::friction_tractions(face.rows, nodes.x, face.z, face.friction, face.history, face.tractions, face.states);
  else
    contact::normal_tractions(face.rows, face.z, face.tractions);
}

/// What friction does on the nodes: the tractions less their normal part.
void add_friction_forces(ContactNodes& nodes, const Interface& face) {
  if (face.friction.coefficient == 0) return;
  std::vector<Vec3> tangential;
  for (std::size_t row = 0; row < face.count(); ++row) {
    const Vec3& n = face.rows.normals[row];
    tangential.emplace_back(face.tractions[row] - n.dot(face.tractions[row]) * n);
  }
  contact::add_forces(face.rows, tangential, nodes.friction_force);
}

}  // namespace

void gather_contact(const model::State& state, std::span<const double> own_z, MortarContact& contact) {
  std::vector<double> local(3 * state.nodes.size()), everywhere(3 * contact.nodes.gid.size());
  for (std::size_t i = 0; i < state.nodes.size(); ++i)
    for (std::size_t c = 0; c < 3; ++c) local[3 * i + c] = state.nodes[i].x[c];
  contact.nodes.gather.forward(local, everywhere, 3);
  for (std::size_t k = 0; k < contact.nodes.gid.size(); ++k) contact.nodes.x[k] = Vec3(&everywhere[3 * k]);
  contact.gather_z.forward(own_z, contact.z, 1);
  std::size_t next = 0;
  for (Interface& face : contact.interfaces)
    if (face.multipliers() > 0) {
      std::copy_n(contact.z.begin() + static_cast<std::ptrdiff_t>(next), face.z.size(), face.z.begin());
      next += face.z.size();
    }
}

void find_contact(MortarContact& contact, Iterate iterate) {
  ContactNodes& nodes = contact.nodes;
  std::ranges::fill(nodes.force, Vec3(Vec3::Zero()));
  std::ranges::fill(nodes.friction_force, Vec3(Vec3::Zero()));
  for (Interface& face : contact.interfaces) {
    if (face.pair.tied && !face.tie.covered.empty()) {
      contact::nodal_normals(face.surfaces, face.topology, nodes.x, face.rows.normals);
      for (std::size_t row = 0; row < face.count(); ++row) face.tractions[row] = Vec3(&face.z[3 * row]);
      contact::add_tie_forces(face.tie, face.tractions, nodes.force);
      continue;
    }
    search(face, nodes.x);
    contact::mortar_rows(face.surfaces, face.topology, face.search.candidates, nodes.x, *face.scratch, face.rows);
    if (!face.keeps(contact)) continue;
    contact::gaps_at(face.rows, nodes.x_before, face.start_gaps);
    if (iterate == Iterate::later) continue;
    face.pressed_before.resize(face.count());
    for (std::size_t row = 0; row < face.count(); ++row) face.pressed_before[row] = face.z[row] > 0 ? 1 : 0;
  }
  if (iterate != Iterate::later) contact.recovery = affordable(contact);
  for (Interface& face : contact.interfaces) {
    if (face.pair.tied) continue;
    if (face.keeps(contact)) find_least_gaps(face, contact.recovery);
    find_pressures(face, iterate == Iterate::first_of_run);
    find_tractions(nodes, face);
    contact::add_forces(face.rows, face.tractions, nodes.force);
    add_friction_forces(nodes, face);
  }
}

void multiplier_residuals(const MortarContact& contact, std::span<double> residual) {
  std::vector<double> all;
  all.reserve(contact.z.size());
  for (const Interface& face : contact.interfaces) {
    std::vector<Vec3> ties;
    if (face.pair.tied) contact::tie_residuals(face.tie, contact.nodes.x, face.rows.normals, ties);
    for (std::size_t row = 0; row < face.count(); ++row) {
      const double area = 1 / face.topology.kappa[row];
      if (face.pair.tied) {
        const Vec3 given = face.tied[row] * (face.stiffness * area * ties[row]);
        const Vec3 redundant = area * (face.tractions[row] - face.tied[row] * face.tractions[row]);
        for (int c = 0; c < 3; ++c) all.push_back(given[c] + redundant[c]);
      } else if (face.multipliers() == 1) {
        const bool pressed = face.active[row] != 0;
        all.push_back(area * (pressed ? -face.stiffness * face.above(row) / face.rows.covered[row] : face.z[row]));
      }
    }
  }
  for (std::size_t k = 0; k < contact.own.size(); ++k) residual[k] = all[static_cast<std::size_t>(contact.own[k])];
}

void keep_contact(MortarContact& contact) {
  contact.z_before = contact.z;
  contact.nodes.x_before = contact.nodes.x;
  contact.traction_before.clear();
  for (Interface& face : contact.interfaces) {
    if (face.pair.tied || face.friction.coefficient == 0) continue;
    contact::keep_friction(face.rows, face.tractions, face.history);
    for (const Vec3& traction : face.history.tractions)
      contact.traction_before.insert(contact.traction_before.end(), traction.data(), traction.data() + 3);
  }
}

void restore_contact(const model::State& state, MortarContact& contact) {
  if (!contact.any()) return;
  std::vector<double> own_z;
  for (const LocalIndex k : contact.own) own_z.push_back(contact.z_before[static_cast<std::size_t>(k)]);
  gather_contact(state, own_z, contact);
  const std::vector<double> tractions = contact.traction_before;
  find_contact(contact, Iterate::first_of_step);
  keep_contact(contact);  // weights and normals are those of the places
  std::size_t next = 0;
  for (Interface& face : contact.interfaces)
    for (Vec3& traction : face.history.tractions) {
      traction = Vec3(&tractions[next]);
      next += 3;
    }
  contact.traction_before = tractions;
}

ContactCounts count(const MortarContact& contact) {
  ContactCounts sum;
  for (const Interface& face : contact.interfaces) {
    sum.segments += static_cast<GlobalIndex>(face.rows.segments);
    sum.pairs += face.search.counts.pairs;
    sum.tests += face.search.counts.tests;
    const auto held = static_cast<GlobalIndex>(
        face.pair.tied ? std::ranges::count_if(face.tie.covered, [](double area) { return area > 0; })
                       : std::ranges::count(face.active, std::uint8_t{1}));
    sum.active += held;
    if (!face.pair.tied) sum.touching += held;
  }
  return sum;
}

double given_in_step(const MortarContact& contact) {
  double sum = 0;
  for (const Interface& face : contact.interfaces)
    for (std::size_t row = 0; row < face.start_gaps.size(); ++row)
      sum += face.z[row] * (face.rows.gaps[row] - face.start_gaps[row]);
  return sum;
}

std::vector<std::uint8_t> branches(const MortarContact& contact) {
  std::vector<std::uint8_t> all;
  for (const Interface& face : contact.interfaces)
    for (std::size_t row = 0; !face.pair.tied && row < face.count(); ++row) {
      const bool keeps = face.active[row] != 0 && !face.least_gaps.empty() && face.least_gaps[row] < 0;
      const int friction = face.states.empty() ? 0 : static_cast<int>(face.states[row]);
      all.push_back(static_cast<std::uint8_t>(face.active[row] + 2 * static_cast<int>(keeps) + 4 * friction));
    }
  return all;
}

namespace {

/// Calls visit(interface, row, local node) for rows whose node this rank holds.
template <class Visit>
void for_each_row_here(const MortarContact& contact, const Visit& visit) {
  for (const Interface& face : contact.interfaces)
    for (std::size_t row = 0; row < face.count(); ++row) {
      const LocalIndex here = contact.nodes.here[static_cast<std::size_t>(face.surfaces.rows[row])];
      if (here != no_index) visit(face, row, static_cast<std::size_t>(here));
    }
}

}  // namespace

std::vector<double> contact_pressures(const MortarContact& contact, LocalIndex nodes) {
  std::vector<double> pressure(static_cast<std::size_t>(nodes), 0.0);
  for_each_row_here(contact, [&](const Interface& face, std::size_t row, std::size_t node) {
    const double z = face.pair.tied ? face.rows.normals[row].dot(face.tractions[row]) : face.z[row];
    pressure[node] = pressure[node] == 0 ? z : std::max(pressure[node], z);
  });
  return pressure;
}

std::vector<double> contact_gaps(const MortarContact& contact, LocalIndex nodes) {
  std::vector<double> gap(static_cast<std::size_t>(nodes), 0.0);
  for_each_row_here(contact, [&](const Interface& face, std::size_t row, std::size_t node) {
    if (face.pair.tied || face.rows.covered[row] == 0) return;
    const double own = face.mean_gap(row);
    gap[node] = gap[node] == 0 ? own : std::min(gap[node], own);
  });
  return gap;
}

double penetration(const MortarContact& contact) {
  double deepest = 0;
  for (const Interface& face : contact.interfaces)
    for (std::size_t row = 0; !face.pair.tied && row < face.count(); ++row)
      deepest = std::max(deepest, -face.mean_gap(row));
  return deepest;
}

}  // namespace brunt::implicit
