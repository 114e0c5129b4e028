// SPDX-License-Identifier: Apache-2.0
// The side from which a node touches a two-sided face. It is determined at first contact and remembered while contact
// lasts, so a node that is pressed through the middle surface is pushed back to its side.
#pragma once
#include <span>

#include "contact/data/history.hpp"
#include "contact/detection/encounter.hpp"

namespace brunt::contact {

/// Sets the sides of the two-sided faces among the encounters (of one slave with the faces of one body; only `face` and
/// the clearance are set): the remembered one; otherwise that of a remembered face across an edge, since a node slides
/// from face to face; otherwise the side of the node, or the side from which it comes if its path passes through.
/// remembered: of this slave.
void find_sides(const FacesInMotion& scene, const NodeMotion& slave, std::span<const HistoryRecord> remembered,
                std::span<Encounter> encounters);

}  // namespace brunt::contact
