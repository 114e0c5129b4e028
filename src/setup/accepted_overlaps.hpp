// SPDX-License-Identifier: Apache-2.0
// initial_overlap: offset - the overlaps that contact treats as touching.
#pragma once
#include <vector>

#include "contact/detection/detection.hpp"
#include "setup/initial_gaps.hpp"

namespace brunt::setup {

/// Overlaps to keep, and those that were to be moved, in the form that detection needs: ordered by (node, body), each
/// once. The nodes are those of a mesh in canonical order.
std::vector<contact::AcceptedOverlap> accepted_overlaps(const std::vector<InitialOverlap>& overlaps);

}  // namespace brunt::setup
