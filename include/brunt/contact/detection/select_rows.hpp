// SPDX-License-Identifier: Apache-2.0
// Which of the faces that a slave node meets become rows: one at a convex edge, one for each face at a concave place.
#pragma once
#include <span>

#include "brunt/contact/data/options.hpp"
#include "brunt/contact/detection/encounter.hpp"

namespace brunt::contact {

constexpr std::size_t most_rows_of_a_node = 4;

/// Sorts the encounters (of one slave, all bodies) so that those to keep come first, merges those that are one, and
/// returns how many are kept, at most most_rows_of_a_node. Faces that the slave's own surface opposes by less than half
/// of the best are left out.
std::size_t select_rows(std::span<const MasterFace> faces, std::span<const NodeMotion> motion, const NodeMotion& slave,
                        double dt, Criterion criterion, const Tolerances& tolerances, std::span<Encounter> encounters);

}  // namespace brunt::contact
