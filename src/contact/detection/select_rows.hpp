// SPDX-License-Identifier: Apache-2.0
// Selects the faces of a slave node that become rows: one at a convex edge, one for each face at a concave place.
#pragma once
#include <span>

#include "contact/data/options.hpp"
#include "contact/detection/encounter.hpp"

namespace brunt::contact {

constexpr std::size_t most_rows_of_a_node = 4;

/// Sorts the encounters (of one slave, all bodies) so that the selected ones come first, merges equal ones, and returns
/// the number of selected ones, at most most_rows_of_a_node. Faces with an opposition below half of the best one are
/// excluded.
std::size_t select_rows(const FacesInMotion& scene, const NodeMotion& slave, Criterion criterion,
                        std::span<Encounter> encounters);

}  // namespace brunt::contact
