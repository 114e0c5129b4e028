// SPDX-License-Identifier: Apache-2.0
// Pressure and gap of the last step, for output.
#include <algorithm>
#include <cmath>
#include <utility>

#include "contact/anchors/mortar_ties.hpp"
#include "contact/contact.hpp"
#include "mortar_step.hpp"
#include "slave.hpp"

namespace brunt::contact {
namespace {

/// Local nodes of the mesh up to the last one on the surface.
std::size_t surface_node_count(const Surface& surface) {
  return surface.model_node.empty() ? 0 : static_cast<std::size_t>(surface.model_node.back()) + 1;
}

std::size_t model_slave(const Contact& contact, const Row& row) {
  return static_cast<std::size_t>(nth(contact.surface.model_node, surface_slave(contact, row)));
}

/// What of these facets looks against the normal [length^2].
double area_against(const Contact& contact, const Vec3& normal, std::span<const LocalIndex> facets) {
  double area = 0;
  for (const LocalIndex facet : facets) area += std::max(0.0, -normal.dot(nth(contact.step.facet_area, facet)));
  return area;
}

}  // namespace

double area_of_slave(const Contact& contact, const Row& row) {
  const Candidates& candidates = contact.lists.candidates;
  const auto slave = std::ranges::lower_bound(candidates.slave, row.nodes[0]) - candidates.slave.begin();
  return area_against(contact, row.normal, candidates.slave_facets.row(static_cast<LocalIndex>(slave)));
}

/// The same on a wall; nothing where wall pressures were not asked for.
double area_on_wall(const Contact& contact, const Row& row) {
  const ContactLists& lists = contact.lists;
  if (!contact.settings.wall_pressures) return 0;
  const auto wall = static_cast<std::int32_t>(row.key.master);
  const auto key = [](const WallCandidate& c) { return std::pair(c.wall, c.node); };
  const auto candidate = std::ranges::lower_bound(lists.wall_candidates, std::pair(wall, row.nodes[0]), {}, key);
  return area_against(contact, row.normal,
                      lists.wall_facets.row(static_cast<LocalIndex>(candidate - lists.wall_candidates.begin())));
}

std::vector<double> pressures(const Contact& contact, double dt) {
  const std::vector<Row>& rows = contact.step.rows;
  const std::vector<Vec3>& impulses = contact.step.impulses;
  const bool two_passes = contact.derived.two_passes;
  std::vector<double> pressure(surface_node_count(contact.surface), 0.0), pushes(pressure.size(), 0.0),
      count(pressure.size(), 0.0);
  if (!(dt > 0)) return pressure;
  std::vector<Vec3> given(pressure.size(), Vec3::Zero());  // by the other bodies
  if (two_passes) add_impulses(contact, given);
  for (std::size_t q = 0; q < rows.size(); ++q) {
    if (rows[q].is_edge()) continue;
    const std::size_t node = model_slave(contact, rows[q]);
    if (rows[q].is_wall()) {
      given[node] -= impulses[q];
      continue;
    }
    pushes[node] += rows[q].normal.dot(impulses[q]);
    count[node] += 1;
  }
  for (std::size_t q = 0; q < rows.size(); ++q) {
    const Row& row = rows[q];
    if (row.is_edge()) continue;
    const std::size_t node = model_slave(contact, row);
    const double area = row.is_wall()         ? area_on_wall(contact, row)
                        : row.is_mortar()     ? area_of_mortar_row(contact, row)
                        : row.is_mortar_tie() ? find_mortar_tie(contact.tied.mortar, row.key)->area
                                              : area_of_slave(contact, row);
    double push = row.normal.dot(impulses[q]);
    if (two_passes && !row.is_wall() && !row.is_mortar() &&
        !row.is_mortar_tie()) {  // the rows that it is a master's corner of push a node as well, or alone
      const double share = pushes[node] > 0 ? push / pushes[node] : 1 / count[node];
      push = share * std::max(0.0, row.normal.dot(given[node]));
    }
    if (area > 0) pressure[node] += push / (dt * area);
  }
  return pressure;
}

std::vector<double> gaps(const Contact& contact) {
  std::vector<double> gap(surface_node_count(contact.surface), 0.0);
  std::vector<char> seen(gap.size(), 0);
  for (const Row& row : contact.step.rows) {
    if (row.is_edge()) continue;
    const std::size_t node = model_slave(contact, row);
    gap[node] = seen[node] ? std::min(gap[node], row.gap) : row.gap;
    seen[node] = 1;
  }
  return gap;
}

}  // namespace brunt::contact
