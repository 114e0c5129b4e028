// SPDX-License-Identifier: Apache-2.0
#include "brunt/implicit/interface_forces.hpp"

#include <array>
#include <bit>

namespace brunt::implicit {
namespace {

constexpr auto width = static_cast<std::size_t>(interface_force_width);

}  // namespace

InterfaceForce force_on_slave(const Interface& face) {
  InterfaceForce sum;
  for (std::size_t row = 0; row < face.count(); ++row) {
    const double area = face.pair.tied ? face.tie.covered[row] : face.rows.covered[row];
    if (area == 0) continue;
    const Vec3 force = area * face.tractions[row];
    const Vec3& normal = face.rows.normals[row];
    const Vec3 tangential = force - normal.dot(force) * normal;
    for (int c = 0; c < 3; ++c) {
      sum.all[c] += force[c];
      sum.friction[c] += tangential[c];
    }
    sum.normal_size += (force - tangential).norm();
    sum.friction_size += tangential.norm();
  }
  return sum;
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
