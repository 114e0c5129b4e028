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
    contact::penalty_pressures(face.rows, face.topology, face.stiffness, {}, face.z);
    for (std::size_t row = 0; row < face.count(); ++row) face.active[row] = face.z[row] > 0 ? 1 : 0;
    return;
  }
  contact::choose_active(face.rows, face.topology, face.z, face.stiffness, face.active);
  for (std::size_t row = 0; first && row < face.count(); ++row)
    if (face.touches[row] != 0 && face.rows.covered[row] > 0) face.active[row] = 1;
}

void find_tractions(const ContactNodes& nodes, Interface& face) {
  if (face.friction.coefficient > 0)
    contact::friction_tractions(face.rows, face.topology, nodes.x, face.z, face.friction, face.history, face.tractions,
                                face.states);
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

void find_contact(MortarContact& contact, bool first) {
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
    if (face.pair.tied) continue;  // at the start
    find_pressures(face, first);
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
        // along directions in which supports hold the slave's node there is nothing to tie
        const Mat3& free = contact.nodes.free[static_cast<std::size_t>(face.surfaces.rows[row])];
        const bool covered = face.tie.covered[row] > 0;
        const Vec3 given = covered ? Vec3(free * (face.stiffness * area * ties[row])) : Vec3(Vec3::Zero());
        const Vec3 redundant =
            area * (covered ? Vec3(face.tractions[row] - free * face.tractions[row]) : face.tractions[row]);
        for (int c = 0; c < 3; ++c) all.push_back(given[c] + redundant[c]);
      } else if (face.multipliers() == 1) {
        all.push_back(face.active[row] != 0 ? -face.stiffness * face.rows.gaps[row] : area * face.z[row]);
      }
    }
  }
  for (std::size_t k = 0; k < contact.own.size(); ++k) residual[k] = all[static_cast<std::size_t>(contact.own[k])];
}

void keep_contact(MortarContact& contact) {
  contact.z_before = contact.z;
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
  find_contact(contact, false);
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
