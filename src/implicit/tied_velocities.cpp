// SPDX-License-Identifier: Apache-2.0
#include "implicit/tied_velocities.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "time/driven_start.hpp"

namespace brunt::implicit {
namespace {

/// Largest rate at which the equations of this rank's rows change, and the largest speed of their nodes [length/time].
struct Rates {
  double apart = 0, speed = 0;
};

Rates rates_of(const Interface& face, std::span<const Vec3> velocity) {
  Rates rates;
  for (std::size_t row = 0; row < face.count(); ++row) {
    if (face.start.tie.covered[row] == 0) continue;
    const auto index = static_cast<LocalIndex>(row);
    const std::span<const LocalIndex> nodes = face.start.tie.weights.nodes.row(index),
                                      turned = face.iterate.levers.nodes.row(index);
    Vec3 rate = Vec3::Zero();
    for (std::size_t k = 0; k < nodes.size(); ++k) {
      const Vec3& v = nth(velocity, nodes[k]);
      rate += face.start.tie.weights.row(index)[k] * v;
      rates.speed = std::max(rates.speed, v.norm());
    }
    for (std::size_t k = 0; k < turned.size(); ++k)
      rate += face.iterate.levers.row(index)[k] * nth(velocity, turned[k]);
    rates.apart = std::max(rates.apart, (face.start.tied[row] * rate).norm() / face.start.tie.covered[row]);
  }
  return rates;
}

}  // namespace

std::vector<std::string> warnings_of_tied_velocities(const Scene& scene, const Solver& solver,
                                                     const std::string& velocity_unit) {
  std::vector<std::string> warnings;
  if (solver.settings.scheme == model::Scheme::statics) return warnings;
  const auto tied = [](const Interface& face) { return face.pair.tied; };
  const MortarContact& contact = solver.contact;
  if (std::ranges::none_of(contact.interfaces, tied)) return warnings;
  std::vector<double> local, here(3 * contact.nodes.gid.size());
  for (const model::NodeLine& node : scene.state.nodes) local.insert(local.end(), node.v, node.v + 3);
  contact.nodes.gather.forward(local, here, 3);
  std::vector<Vec3> velocity;
  for (std::size_t k = 0; k < here.size(); k += 3) velocity.emplace_back(&here[k]);
  for (const Interface& face : contact.interfaces) {
    if (!face.pair.tied) continue;
    const Rates rates = rates_of(face, velocity);
    const double apart = scene.links.ranks.max(rates.apart), speed = scene.links.ranks.max(rates.speed);
    if (!(apart > time::same_speed * speed)) continue;
    const auto part = [&](std::int32_t b) { return nth(scene.model.blocks, b).part; };
    warnings.push_back(fmt::format(
        "{}: the initial velocities of the tied parts {} and {} differ by {:.3g}{} at their seam; the force "
        "of the tie will alternate from step to step. Give both parts the same velocity there",
        face.pair.entry, part(face.pair.slave), part(face.pair.master), apart,
        velocity_unit.empty() ? "" : ' ' + velocity_unit));
  }
  return warnings;
}

}  // namespace brunt::implicit
