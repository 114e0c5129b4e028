// SPDX-License-Identifier: Apache-2.0
// The slave node of a row, in the surface and in the model.
#pragma once
#include "contact/contact.hpp"

namespace brunt::contact {

/// The surface node of a contact node that this rank's mesh has.
inline LocalIndex surface_node_of(const Contact& contact, LocalIndex contact_node) {
  return nth(contact.lists.nodes.surface_node, contact_node);
}

inline LocalIndex surface_slave(const Contact& contact, const Row& row) {
  return surface_node_of(contact, row.nodes[0]);
}

/// Of the slave's contact faces, ascending. Of a row with a face or a wall.
inline std::span<const std::int32_t> blocks_of_slave(const Contact& contact, const Row& row) {
  return contact.surface.blocks.row(surface_slave(contact, row));
}

/// The slave node's share of each face around it, projected on the plane across the normal: sides of a body carry no
/// load [length^2].
double area_of_slave(const Contact& contact, const Row& row);

}  // namespace brunt::contact
