// SPDX-License-Identifier: Apache-2.0
#include "implicit/mortar/interface_forces.hpp"

#include <algorithm>
#include <array>
#include <bit>

#include "mortar_shares.hpp"
#include "self_sides.hpp"

namespace brunt::implicit {
namespace {

constexpr auto width = static_cast<std::size_t>(interface_force_width);

/// For each node up to the last one of the slave: whether it is one of them; empty unless forces are consistent.
std::vector<bool> nodes_of_slave(const Interface& face) {
  std::vector<bool> of_slave;
  for (std::size_t facet = 0; face.consistent() && facet < face.surfaces.slave.size(); ++facet)
    for (const LocalIndex node : face.surfaces.slave[facet]) {
      if (node == no_index) continue;
      const auto i = static_cast<std::size_t>(node);
      if (i >= of_slave.size()) of_slave.resize(i + 1);
      of_slave[i] = true;
    }
  return of_slave;
}

/// What the levers of a row do to the nodes of the slave.
Vec3 lever_force_on_slave(const Interface& face, std::size_t row, const std::vector<bool>& of_slave) {
  Vec3 sum = Vec3::Zero();
  if (of_slave.empty() || face.iterate.z[row] == 0) return sum;
  const auto index = static_cast<LocalIndex>(row);
  const std::span<const LocalIndex> nodes = face.iterate.gap_levers.nodes.row(index);
  for (std::size_t k = 0; k < nodes.size(); ++k)
    if (const auto node = static_cast<std::size_t>(nodes[k]);
        face.self ? is_of_slave(face, row, nodes[k]) : node < of_slave.size() && of_slave[node])
      sum += face.iterate.z[row] * face.iterate.gap_levers.row(index)[k];
  return sum;
}

}  // namespace

InterfaceForce force_on_slave(const Interface& face) {
  std::vector<double> of_rows(width * face.count());
  const std::vector<bool> of_slave = nodes_of_slave(face);
  for (std::size_t row = 0; row < face.count(); ++row) {
    const double area = face.pair.tied ? face.start.tie.covered[row] : face.iterate.rows.covered[row];
    if (area == 0) continue;
    const Vec3 force = area * face.iterate.tractions[row];
    const Vec3& normal = face.iterate.rows.normals[row];
    const Vec3 tangential = force - normal.dot(force) * normal;
    double* const of_row = &of_rows[width * row];
    const Vec3 whole = force + lever_force_on_slave(face, row, of_slave);
    std::copy_n(whole.data(), 3, of_row);
    std::copy_n(tangential.data(), 3, of_row + 3);
    of_row[6] = (force - tangential).norm();
    of_row[7] = tangential.norm();
  }
  const std::vector<double> all = told_to_all(face, of_rows, interface_force_width);
  std::array<double, width> sum{};
  for (std::size_t k = 0; k < all.size(); ++k) sum[k % width] += all[k];
  return std::bit_cast<InterfaceForce>(sum);
}

void book_interfaces(double dt, double of_impulse, MortarContact& contact) {
  for (std::size_t k = 0; k < contact.interfaces.size(); ++k) {
    const auto value = std::bit_cast<std::array<double, width>>(force_on_slave(contact.interfaces[k]));
    for (std::size_t i = 0; i < width; ++i) {
      double& before = contact.forces_before[width * k + i];
      contact.impulses[width * k + i] += dt * (of_impulse * value[i] + (1 - of_impulse) * before);
      before = value[i];
    }
  }
}

}  // namespace brunt::implicit
