// SPDX-License-Identifier: Apache-2.0
// Contact of a part with itself: its set-up, and the choice of roles.
#pragma once
#include <span>
#include <vector>

#include "mortar_shares.hpp"

namespace brunt::implicit {

/// Facets of both sides, capture distance and walls of a part in contact with itself.
void lay_self(const WholeSurfaces& whole, WholeInterface& of);

/// The facets that this rank integrates, as numbers of the whole surface, and what these cannot meet. Facets cannot
/// meet if they share a node, or if they are the two sides of one wall in the initial configuration: no deformation
/// brings them into contact. reference: of all nodes.
void share_self(const std::vector<contact::FacetNodes>& facets, std::span<const Vec3> reference,
                const std::vector<std::size_t>& mine, SelfContact& self);

/// Chooses the roles of the next step from the positions and pressures of the accepted one, and keeps those of the
/// accepted one in MortarContact::roles_before. Collective.
void choose_roles(const comm::Communicator& ranks, MortarContact& contact);

/// Whether the node is a corner of the slave facets of the row.
bool is_of_slave(const Interface& face, std::size_t row, LocalIndex node);

/// After a restart: the roles that the accepted step had.
void take_roles_before(MortarContact& contact);

}  // namespace brunt::implicit
