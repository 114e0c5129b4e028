// SPDX-License-Identifier: Apache-2.0
// What contact tells of its last step for pictures.
#include <algorithm>
#include <cmath>

#include "brunt/contact/contact.hpp"

namespace brunt::contact {

std::vector<double> Contact::pressures(double dt) const {
  std::vector<double> pressure(surface_node_count(), 0.0), pushes(pressure.size(), 0.0), count(pressure.size(), 0.0);
  if (!(dt > 0)) return pressure;
  std::vector<Vec3> given(pressure.size(), Vec3::Zero());  // by the other bodies
  if (two_passes_) add_impulses(given);
  for (std::size_t q = 0; q < rows_.size(); ++q) {
    if (rows_[q].is_wall()) given[model_node_of(rows_[q])] -= impulses_[q];
    if (rows_[q].is_wall() || rows_[q].is_edge()) continue;
    pushes[model_node_of(rows_[q])] += rows_[q].normal.dot(impulses_[q]);
    count[model_node_of(rows_[q])] += 1;
  }
  for (std::size_t q = 0; q < rows_.size(); ++q) {
    const Row& row = rows_[q];
    if (row.is_wall() || row.is_edge()) continue;
    const std::size_t node = model_node_of(row);
    const double area = area_of_slave(row);
    double push = row.normal.dot(impulses_[q]);
    if (two_passes_) {  // the rows that it is a master's corner of push a node as well, or alone
      const double share = pushes[node] > 0 ? push / pushes[node] : 1 / count[node];
      push = share * std::max(0.0, row.normal.dot(given[node]));
    }
    if (area > 0) pressure[node] += push / (dt * area);
  }
  return pressure;
}

std::vector<double> Contact::gaps() const {
  std::vector<double> gap(surface_node_count(), 0.0);
  std::vector<char> seen(gap.size(), 0);
  for (const Row& row : rows_) {
    if (row.is_edge()) continue;
    const std::size_t node = model_node_of(row);
    gap[node] = seen[node] ? std::min(gap[node], row.gap) : row.gap;
    seen[node] = 1;
  }
  return gap;
}

std::size_t Contact::surface_node_count() const {
  return surface_.model_node.empty() ? 0 : static_cast<std::size_t>(surface_.model_node.back()) + 1;
}

std::size_t Contact::model_node_of(const Row& row) const {
  const LocalIndex surface_node = lists_.nodes.surface_node[static_cast<std::size_t>(row.nodes[0])];
  return static_cast<std::size_t>(surface_.model_node[static_cast<std::size_t>(surface_node)]);
}

}  // namespace brunt::contact
