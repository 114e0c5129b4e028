// SPDX-License-Identifier: Apache-2.0
// Nodes of probes that depend on more than a name: the nearest node to a point, those of a section, and those between
// parts.
#pragma once
#include <span>
#include <string>
#include <vector>

#include "mesh/canonical.hpp"
#include "scene/input.hpp"

namespace brunt::scene {

/// Reduces the probe's set, or all nodes if it has none, to the node nearest to its point; of equally near ones to that
/// with the smallest number in the mesh file.
void keep_nearest(const Probe& probe, const std::string& set, mesh::CanonicalMesh& whole);

/// Creates the sets of a section: its nodes and, for a plane, the nodes in front of it of the elements that it cuts. An
/// element is cut if it has nodes in front of the plane (farther than `on_plane`) and others; the others are nodes of
/// the section. For a set, they are its nodes that belong to the parts. Returns the number of nodes of the section.
std::size_t make_section(const Probe& probe, std::size_t entry, std::span<const std::string> part_of_block,
                         double on_plane, mesh::CanonicalMesh& whole);

/// Makes the set of nodes that elements of several parts share.
void make_interface(mesh::CanonicalMesh& whole);

}  // namespace brunt::scene
