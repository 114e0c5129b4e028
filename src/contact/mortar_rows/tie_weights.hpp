// SPDX-License-Identifier: Apache-2.0
// The rows of ties from what is covered of the facets around their nodes (contact/TIES.md).
#pragma once
#include <span>

#include "contact/data/mortar_ties.hpp"
#include "contact/mortar_rows/tie_covers.hpp"

namespace brunt::contact {

/// Of all slaves of the scene. covers: with settled functions; sides: those that settled them. Without slave_block.
MortarTies tie_weights(const MortarScene& scene, std::span<const Vec3> sides, const TieCovers& covers);

}  // namespace brunt::contact
