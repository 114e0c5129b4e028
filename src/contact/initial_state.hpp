// SPDX-License-Identifier: Apache-2.0
// Initial data of contact: the overlaps that the scene keeps, as detection finds them (with the same faces and normals
// as in a step), and the tied nodes.
#pragma once
#include "contact/contact.hpp"

namespace brunt::contact {

/// Completes derived.detection.accepted and .fitted. Collective.
void keep_overlaps(Contact& contact, const std::vector<Vec3>& reference, std::span<const Wall> walls);

/// Fills contact.tied, where any pair is tied. Collective.
void make_ties(Contact& contact, const std::vector<Vec3>& reference, std::span<const Wall> walls);

/// After a removal of elements: ties over facets are integrated again, in the geometry of the start, over the facets
/// that are left of it. faces: remaining on this rank, ascending by key; contact.surface already refers to them.
/// Collective.
void renew_ties(Contact& contact, const std::vector<Vec3>& reference, std::span<const mesh::ExteriorFace> faces);

}  // namespace brunt::contact
