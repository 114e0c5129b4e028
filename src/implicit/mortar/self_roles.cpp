// SPDX-License-Identifier: Apache-2.0
// The choice of slaves and masters in contact of a part with itself, the same on every rank.
#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <numbers>

#include "comm/rendezvous.hpp"
#include "contact/mortar/corners.hpp"
#include "contact/mortar/segment.hpp"
#include "self_sides.hpp"

namespace brunt::implicit {
namespace {

using contact::FacingPair;

/// A flag for each row of this rank, followed by those of the rows beside. Collective.
std::vector<char> pressed_rows(const Interface& face) {
  std::vector<double> own(face.count()), beside(face.surfaces.rows_elsewhere.size());
  for (std::size_t row = 0; row < face.count(); ++row) own[row] = face.iterate.z[row] > 0 ? 1 : 0;
  face.numbering.beside.forward(own, beside, 1);
  std::vector<char> pressed;
  for (const std::vector<double>* rows : {&own, &beside})
    for (const double value : *rows) pressed.push_back(value > 0 ? 1 : 0);
  return pressed;
}

/// rows: of the corners of a facet.
bool presses(const contact::FacetNodes& rows, const std::vector<char>& pressed) {
  return std::ranges::any_of(rows, [&](LocalIndex row) { return row != no_index && nth(pressed, row) != 0; });
}

/// A direction to which hardly any surface is parallel. A side whose normals have a component along it looks up.
const Vec3 up(1, std::numbers::sqrt2, std::numbers::sqrt3);

/// The pairs with a segment of the slave facets that this rank counts. Collective.
std::vector<FacingPair> facing_pairs(const Interface& face, std::span<const Vec3> x) {
  std::vector<FacingPair> pairs;
  const std::vector<char> pressed = pressed_rows(face);
  contact::SlavePlane plane;
  contact::SegmentIntegrals segment;
  for (std::size_t facet = 0; facet < face.surfaces.slave.size(); ++facet) {
    const std::span<const LocalIndex> candidates = face.search.candidates.row(static_cast<LocalIndex>(facet));
    const contact::FacetNodes& nodes = face.surfaces.slave[facet];
    if (!face.surfaces.is_ours(facet) || candidates.empty() ||
        !contact::make_slave_plane(contact::CornersOf(nodes, x).span(), plane))
      continue;
    const std::int32_t has_pressure = presses(face.topology.row_of_corner[facet], pressed) ? 1 : 0;
    for (const LocalIndex master : candidates) {
      const auto m = static_cast<std::size_t>(master);
      if (contact::integrate_segment(plane, contact::CornersOf(face.surfaces.master[m], x).span(),
                                     face.surfaces.capture, segment) &&
          segment.distance >= -face.surfaces.deepest(facet, m))
        pairs.push_back({face.self->slave[facet], face.self->master[m], has_pressure, plane.normal.dot(up)});
    }
  }
  return pairs;
}

std::vector<FacingPair> of_all(const comm::Communicator& ranks, const std::vector<FacingPair>& mine) {
  return comm::exchange(ranks, std::vector<std::vector<FacingPair>>(static_cast<std::size_t>(ranks.size()), mine))
      .values;
}

}  // namespace

bool SelfContact::admits(LocalIndex of_slaves, LocalIndex of_masters) const {
  const LocalIndex one = nth(slave, of_slaves), other = nth(master, of_masters);
  return contact::is_slave(nth(roles, one), nth(roles, other), one, other) &&
         !std::ranges::binary_search(never.row(of_slaves), other);
}

LocalIndex SelfContact::number_of(GlobalIndex facet) const {
  return static_cast<LocalIndex>(std::ranges::lower_bound(key, facet) - key.begin());
}

void choose_roles(const comm::Communicator& ranks, MortarContact& contact) {
  contact.roles_before.clear();
  for (Interface& face : contact.interfaces) {
    if (!face.self) continue;
    for (const contact::FacetRole role : face.self->roles) contact.roles_before.push_back(static_cast<double>(role));
    search(face, contact.nodes.x);
    const std::vector<FacingPair> pairs = of_all(ranks, facing_pairs(face, contact.nodes.x));
    face.self->roles = contact::roles_of_facets(pairs, face.self->edge);
    if (face.self->undecided.slave == no_index) face.self->undecided = contact::undecided(pairs, face.self->roles);
  }
}

bool is_of_slave(const Interface& face, std::size_t row, LocalIndex node) {
  const std::span<const LocalIndex> facets = face.topology.facets_around.row(static_cast<LocalIndex>(row));
  return std::ranges::any_of(facets, [&](LocalIndex facet) {
    const contact::FacetNodes& nodes = nth(face.surfaces.slave, facet);
    return std::ranges::find(nodes, node) != nodes.end();
  });
}

std::vector<std::string> warnings_of_roles(const comm::Communicator& ranks, const Vec3& origin,
                                           MortarContact& contact) {
  std::vector<std::string> warnings;
  for (Interface& face : contact.interfaces) {
    if (!face.self || face.self->told || face.self->undecided.slave == no_index) continue;
    face.self->told = true;
    std::vector<double> place(3, -std::numeric_limits<double>::infinity());
    const auto at = std::ranges::find(face.self->slave, face.self->undecided.slave) - face.self->slave.begin();
    if (at < std::ssize(face.self->slave)) {
      const LocalIndex corner = nth(face.surfaces.slave, at)[0];
      const Vec3 x = nth(contact.nodes.x, corner) + origin;
      std::copy_n(x.data(), 3, place.begin());
    }
    ranks.max(place);
    warnings.push_back(fmt::format(
        "{}: near [{:.4g}, {:.4g}, {:.4g}] no choice of slave and master suits all facets that face each other: an odd "
        "number of walls meets there, or contact zones with opposite slaves have grown together. A facet there is the "
        "slave of one facet and the master of another, and pressures are as at the rim of a contact zone (reported "
        "once for each part)",
        face.pair.entry, place[0], place[1], place[2]));
  }
  return warnings;
}

void take_roles_before(MortarContact& contact) {
  std::size_t next = 0;
  for (Interface& face : contact.interfaces)
    if (face.self)
      for (contact::FacetRole& role : face.self->roles)
        role = static_cast<contact::FacetRole>(static_cast<std::int8_t>(contact.roles_before[next++]));
}

}  // namespace brunt::implicit
