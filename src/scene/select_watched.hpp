// SPDX-License-Identifier: Apache-2.0
// Nodes that probes watch and that need more of the mesh than a name: the nearest to a place, those of a section,
// those between parts.
#pragma once
#include <span>
#include <string>
#include <vector>

#include "brunt/mesh/canonical.hpp"
#include "brunt/scene/input.hpp"

namespace brunt::scene {

/// Leaves of the probe's set, or of all nodes where it has none, the one nearest to its point; of equally near ones the
/// one with the smallest number in the mesh file.
void keep_nearest(const Probe& probe, const std::string& set, mesh::CanonicalMesh& whole);

/// Makes the sets of a section: its nodes, and for a plane the nodes in front of it of the elements that it cuts.
/// An element is cut where it has nodes in front of the plane (farther than `on_plane`) and others; the others are the
/// section's nodes. Of a set they are its nodes that belong to the parts. Returns how many nodes the section has.
std::size_t make_section(const Probe& probe, std::size_t entry, std::span<const std::string> part_of_block,
                         double on_plane, mesh::CanonicalMesh& whole);

/// Makes the set of nodes that elements of several parts share.
void make_interface(mesh::CanonicalMesh& whole);

}  // namespace brunt::scene
