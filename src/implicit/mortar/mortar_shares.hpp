// SPDX-License-Identifier: Apache-2.0
// Distribution of whole interfaces to the ranks, and the exchange of masters.
#pragma once
#include <vector>

#include "implicit/mortar/mortar.hpp"
#include "mortar_surfaces.hpp"

namespace brunt::implicit {

/// An interface before distribution: surfaces, topology and ties are whole, nodes are places in WholeSurfaces::nodes.
struct WholeInterface {
  Interface face;
  WholeSide slave, master;
  std::vector<contact::PatchNumbers> master_patch{};  ///< for rows of points: as OwnMasters::patch
};

/// Keeps on each rank the rows of the nodes that it owns, the slave facets around them, and their nodes; masters are
/// those that are near in the reference configuration. Collective.
void share_out(const comm::Communicator& ranks, const model::Model& model, const Unknowns& unknowns,
               const WholeSurfaces& whole, std::vector<WholeInterface> interfaces, MortarContact& contact);

/// Pairs of facets nearer than the capture distance at these positions: candidates for each slave facet.
void search(Interface& face, std::span<const Vec3> x);

/// Sends values of nodes from their owners, `values` of lasting nodes, to all ranks with copies. Collective.
std::vector<Vec3> from_owners(const ContactNodes& nodes, std::span<const Vec3> values);

/// Sends the free directions of nodes from their owners to all ranks with copies: ContactNodes::movable. Collective.
void share_movable(std::span<const Mat3> movable, ContactNodes& nodes);

/// Whether a node has moved by the admitted distance since the last exchange of masters. Collective.
bool masters_wear_out(const comm::Communicator& ranks, const MortarContact& contact);

/// Exchanges the masters that slave facets may meet until a node has moved by `MortarContact::travel`. Nodes after the
/// lasting ones are replaced, and places in histories are updated. Collective.
void tell_masters(const comm::Communicator& ranks, MortarContact& contact);

/// Sums of the contributions of all rows to the nodes that this rank owns, in the order of the rows:
/// ContactNodes::force and ::friction_force. Collective.
void sum_forces(const comm::Communicator& ranks, MortarContact& contact);

/// Sends `width` values for each row of this rank to all rows of all ranks. Collective.
std::vector<double> told_to_all(const Interface& face, std::span<const double> of_rows, int width);

}  // namespace brunt::implicit
