// SPDX-License-Identifier: Apache-2.0
// What each rank keeps of whole interfaces, and the masters that it is told of.
#pragma once
#include <vector>

#include "brunt/implicit/mortar.hpp"
#include "mortar_surfaces.hpp"

namespace brunt::implicit {

/// An interface of which all is known: surfaces, topology and ties are whole, nodes places in WholeSurfaces::nodes.
struct WholeInterface {
  Interface face;
  WholeSide slave, master;
};

/// Leaves each rank the rows of the nodes that it owns, the slave facets around them, and the nodes that go with them;
/// masters are those that are near in the reference configuration. Collective.
void share_out(const comm::Communicator& ranks, const model::Model& model, const Unknowns& unknowns,
               const WholeSurfaces& whole, std::vector<WholeInterface> interfaces, MortarContact& contact);

/// Pairs of facets nearer than the capture distance at these positions: candidates of each slave facet.
void search(Interface& face, std::span<const Vec3> x);

/// Values of nodes that ranks own, `values` of lasting nodes, to all that hold them. Collective.
std::vector<Vec3> from_owners(const ContactNodes& nodes, std::span<const Vec3> values);

/// What is free at nodes that this rank owns, to all that hold them: ContactNodes::movable. Collective.
void share_movable(std::span<const Mat3> movable, ContactNodes& nodes);

/// Has a node made its way since masters were told of? Collective.
bool masters_wear_out(const comm::Communicator& ranks, const MortarContact& contact);

/// Tells ranks of the masters that their slave facets may meet until a node has gone `MortarContact::travel`. Nodes
/// behind the lasting ones are new then, and places in histories follow them. Collective.
void tell_masters(const comm::Communicator& ranks, MortarContact& contact);

/// Sums of what all rows do to the nodes that this rank owns, in the order of the rows: ContactNodes::force and
/// ::friction_force. Collective.
void sum_forces(const comm::Communicator& ranks, MortarContact& contact);

/// `width` values a row of this rank, to all rows of all ranks. Collective.
std::vector<double> told_to_all(const Interface& face, std::span<const double> of_rows, int width);

}  // namespace brunt::implicit
