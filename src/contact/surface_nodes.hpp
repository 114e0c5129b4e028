// SPDX-License-Identifier: Apache-2.0
// Contact data of each node of this rank's surface, other than the faces around it: mobility, initial position, walls
// that hold it, and copies on other ranks.
#pragma once
#include <span>
#include <vector>

#include "comm/communicator.hpp"
#include "comm/halo.hpp"
#include "contact/data/constrained_node.hpp"
#include "contact/data/constraint.hpp"
#include "contact/detection/detection.hpp"
#include "contact/node_views.hpp"
#include "contact/settings.hpp"
#include "contact/surface/surface.hpp"

namespace brunt::contact {

/// Surface nodes on several ranks: copies take the owner's velocity.
struct SurfaceCopies {
  comm::Halo halo;
  std::vector<LocalIndex> foreign;  ///< surface nodes owned elsewhere
  std::vector<LocalIndex> lent;     ///< surface nodes owned here, once for each copy elsewhere
  bool exist = false;               ///< on any rank
  std::vector<double> sent, received;
};

struct SurfaceNodes {
  std::vector<Mobility> mobility;
  /// 1 + the number of the body of the node, 0 for other nodes. A double, since it is exchanged like other values;
  /// empty without rigid bodies.
  std::vector<double> carrier{};
  std::vector<Vec3> reference{};  ///< at the start [length]; empty where no overlaps of the start are accepted
  /// Of nodes owned here, else 0, see transits.hpp [time]; empty without Impact::elastic.
  std::vector<double> transit{};
  std::vector<char> held;  ///< wall by wall, a flag a surface node: it started in the plane of a bilateral wall
  SurfaceCopies copies;
};

/// inverse_mass: of the mesh's local nodes. Nodes of bodies have none of their own.
std::vector<Mobility> surface_mobility(const Surface& surface, std::span<const double> inverse_mass,
                                       std::span<const ConstrainedNode> constrained, std::span<const double> carrier);

/// SurfaceNodes::carrier.
std::vector<double> surface_carriers(const Surface& surface, std::span<const BodyNode> on_bodies);

/// Flags of the nodes that lie in the plane of a bilateral wall, within Tolerances::rounding of the mean face edge.
/// reference: of the mesh's local nodes.
std::vector<char> held_by_walls(const Surface& surface, std::span<const Vec3> reference, std::span<const Wall> walls,
                                const Tolerances& tolerances);

/// Collective.
SurfaceCopies link_copies(const comm::Communicator& ranks, const Surface& surface);

/// Copies take the velocities of their owners. Collective.
void share_velocity(const Surface& surface, MutableVectorView velocity, SurfaceCopies& copies);

}  // namespace brunt::contact
