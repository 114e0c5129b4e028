// SPDX-License-Identifier: Apache-2.0
// From which side a node meets a two-sided face. It is decided when they first meet and remembered for as long as they
// do, so that a node that is pressed through the middle is pushed back to where it came from.
#pragma once
#include <span>

#include "brunt/contact/data/history.hpp"
#include "brunt/contact/detection/encounter.hpp"

namespace brunt::contact {

/// Sets the sides of the two-sided faces among the encounters (of one slave with the faces of one body; only `face` and
/// the clearance are set): the one remembered; else that of a face across an edge that is remembered, since a node
/// slides from face to face; else the one that the node is on, or comes from if its path passes through. remembered: of
/// this slave.
void find_sides(const FacesInMotion& scene, const Tolerances& tolerances, const NodeMotion& slave,
                std::span<const HistoryRecord> remembered, std::span<Encounter> encounters);

}  // namespace brunt::contact
