// SPDX-License-Identifier: Apache-2.0
#include "contact/surface_nodes.hpp"

#include <algorithm>
#include <cmath>

#include "comm/rendezvous.hpp"
#include "contact/data/tolerances.hpp"

namespace brunt::contact {

std::vector<Mobility> surface_mobility(const Surface& surface, std::span<const double> inverse_mass,
                                       std::span<const ConstrainedNode> constrained, std::span<const double> carrier) {
  std::vector<Mobility> mobility;
  for (const LocalIndex node : surface.model_node) mobility.push_back({nth(inverse_mass, node), Mat3::Identity()});
  for (const ConstrainedNode& held : constrained) {
    const auto found = std::ranges::lower_bound(surface.model_node, held.node);
    if (found == surface.model_node.end() || *found != held.node) continue;
    nth(mobility, found - surface.model_node.begin()).projector = held.free;
  }
  for (std::size_t i = 0; i < carrier.size(); ++i)
    if (carrier[i] > 0) mobility[i].inverse_mass = 0;
  return mobility;
}

std::vector<double> surface_carriers(const Surface& surface, std::span<const BodyNode> on_bodies) {
  std::vector<double> carrier(surface.model_node.size(), 0.0);
  for (const BodyNode& carried : on_bodies) {
    const auto found = std::ranges::lower_bound(surface.model_node, carried.node);
    if (found == surface.model_node.end() || *found != carried.node) continue;
    nth(carrier, found - surface.model_node.begin()) = 1.0 + carried.body;
  }
  return carrier;
}

std::vector<char> held_by_walls(const Surface& surface, std::span<const Vec3> reference, std::span<const Wall> walls,
                                const Tolerances& tolerances) {
  std::vector<char> held;
  held.reserve(walls.size() * surface.gid.size());
  for (const Wall& wall : walls)
    for (std::size_t i = 0; i < surface.model_node.size(); ++i) {
      const double gap = (nth(reference, surface.model_node[i]) - wall.point).dot(wall.normal);
      const bool acts = acts_on(wall, surface.blocks.row(static_cast<LocalIndex>(i)));
      held.push_back(wall.bilateral && acts && std::abs(gap) <= tolerances.rounding * surface.mean_edge ? 1 : 0);
    }
  return held;
}

SurfaceCopies link_copies(const comm::Communicator& ranks, const Surface& surface) {
  SurfaceCopies copies;
  std::vector<comm::RemoteSlot> source;
  std::vector<std::vector<LocalIndex>> wanted(static_cast<std::size_t>(ranks.size()));
  for (std::size_t i = 0; i < surface.gid.size(); ++i) {
    if (surface.owns(static_cast<LocalIndex>(i), ranks.rank())) continue;
    copies.foreign.push_back(static_cast<LocalIndex>(i));
    source.push_back({surface.home[i].rank, surface.home[i].index});
    nth(wanted, surface.home[i].rank).push_back(surface.home[i].index);
  }
  copies.lent = comm::exchange(ranks, wanted).values;
  copies.exist = ranks.any(!copies.lent.empty());
  if (copies.exist) copies.halo = comm::Halo(ranks, static_cast<LocalIndex>(surface.gid.size()), source);
  copies.sent.resize(3 * surface.gid.size());
  copies.received.resize(3 * copies.foreign.size());
  return copies;
}

void share_velocity(const Surface& surface, MutableVectorView velocity, SurfaceCopies& copies) {
  if (!copies.exist) return;
  for (const LocalIndex node : copies.lent) {
    const auto i = static_cast<std::size_t>(node);
    Eigen::Map<Vec3>(copies.sent.data() + 3 * i) = velocity[surface.model_node[i]];
  }
  copies.halo.forward(copies.sent, copies.received, 3);
  for (std::size_t i = 0; i < copies.foreign.size(); ++i)
    velocity.set(nth(surface.model_node, copies.foreign[i]), Vec3(&copies.received[3 * i]));
}

}  // namespace brunt::contact
