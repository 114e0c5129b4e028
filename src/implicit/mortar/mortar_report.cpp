// SPDX-License-Identifier: Apache-2.0
// Reports of mortar contact: counts, branches of rows, output fields.
#include <algorithm>
#include <array>

#include "implicit/mortar/mortar.hpp"

namespace brunt::implicit {
namespace {

/// Pairs of the slave facets that are counted on this rank.
GlobalIndex pairs_of(const Interface& face) {
  if (face.pair.tied) return face.search.counts.pairs;
  if (face.of_points) return 0;  // they are those of the facets' interface
  GlobalIndex pairs = 0;
  for (std::size_t facet = 0; facet < face.surfaces.slave.size(); ++facet)
    if (face.surfaces.is_ours(facet))
      pairs += static_cast<GlobalIndex>(face.search.candidates.row(static_cast<LocalIndex>(facet)).size());
  return pairs;
}

}  // namespace

ContactCounts count(const MortarContact& contact) {
  ContactCounts sum;
  for (const Interface& face : contact.interfaces) {
    sum.segments += static_cast<GlobalIndex>(face.iterate.rows.segments);
    sum.pairs += pairs_of(face);
    sum.tests += face.search.counts.tests;
    const auto held = static_cast<GlobalIndex>(
        face.pair.tied ? std::ranges::count_if(face.start.tie.covered, [](double area) { return area > 0; })
                       : std::ranges::count(face.iterate.active, std::uint8_t{1}));
    sum.active += held;
    if (!face.pair.tied) sum.touching += held;
  }
  return sum;
}

void tally(const comm::Communicator& ranks, MortarContact& contact) {
  const ContactCounts here = count(contact);
  std::array<GlobalIndex, 5> sum{here.segments, here.pairs, here.tests, here.active, here.touching};
  ranks.sum(sum);
  contact.counts = {sum[0], sum[1], sum[2], sum[3], sum[4]};
}

std::vector<std::uint8_t> branches(const MortarContact& contact) {
  std::vector<std::uint8_t> all;
  for (const Interface& face : contact.interfaces)
    for (std::size_t row = 0; !face.pair.tied && row < face.count(); ++row) {
      const bool keeps = face.iterate.active[row] != 0 && !face.least.required.empty() && face.least.required[row] < 0;
      const int friction = face.iterate.states.empty() ? 0 : static_cast<int>(face.iterate.states[row]);
      all.push_back(static_cast<std::uint8_t>(face.iterate.active[row] + 2 * static_cast<int>(keeps) + 4 * friction));
    }
  return all;
}

namespace {

/// Calls visit(interface, row, local node) for the rows of this rank.
template <class Visit>
void for_each_row(const MortarContact& contact, const Visit& visit) {
  for (const Interface& face : contact.interfaces)
    for (std::size_t row = 0; row < face.count(); ++row)
      visit(face, row, static_cast<std::size_t>(nth(contact.nodes.source, face.surfaces.rows[row]).index));
}

}  // namespace

std::vector<double> contact_pressures(const MortarContact& contact, LocalIndex nodes) {
  std::vector<double> pressure(static_cast<std::size_t>(nodes), 0.0);
  for_each_row(contact, [&](const Interface& face, std::size_t row, std::size_t node) {
    const double z =
        face.pair.tied ? face.iterate.rows.normals[row].dot(face.iterate.tractions[row]) : face.iterate.z[row];
    pressure[node] = pressure[node] == 0 ? z : std::max(pressure[node], z);
  });
  return pressure;
}

std::vector<double> contact_gaps(const MortarContact& contact, LocalIndex nodes) {
  std::vector<double> gap(static_cast<std::size_t>(nodes), 0.0);
  for_each_row(contact, [&](const Interface& face, std::size_t row, std::size_t node) {
    if (face.pair.tied || face.iterate.rows.covered[row] == 0) return;
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
