// SPDX-License-Identifier: Apache-2.0
#include "brunt/implicit/interface_forces.hpp"

#include <algorithm>
#include <array>
#include <bit>

#include "mortar_shares.hpp"

namespace brunt::implicit {
namespace {

constexpr auto width = static_cast<std::size_t>(interface_force_width);

}  // namespace

InterfaceForce force_on_slave(const Interface& face) {
  std::vector<double> of_rows(width * face.count());
  for (std::size_t row = 0; row < face.count(); ++row) {
    const double area = face.pair.tied ? face.tie.covered[row] : face.rows.covered[row];
    if (area == 0) continue;
    const Vec3 force = area * face.tractions[row];
    const Vec3& normal = face.rows.normals[row];
    const Vec3 tangential = force - normal.dot(force) * normal;
    double* const of_row = &of_rows[width * row];
    std::copy_n(force.data(), 3, of_row);
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
