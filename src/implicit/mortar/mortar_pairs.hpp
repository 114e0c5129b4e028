// SPDX-License-Identifier: Apache-2.0
// The interfaces of one pair of parts.
#pragma once
#include "mortar_shares.hpp"

namespace brunt::implicit {

/// Rows of the facets of the slave: one for each node, or one for each smooth patch around it.
void lay_rows(const WholeSurfaces& whole, bool by_patch, contact::MortarSurfaces& surfaces);

/// Splits a pair that asks for it (`edges`) at the sharp edges of its surfaces: an interface for each colour of the
/// master's smooth regions, so that a row never sees two sides of an edge at once, and one of points for the nodes of
/// sharp edges of each side.
std::vector<WholeInterface> split_at_edges(const WholeSurfaces& whole, WholeInterface pair);

}  // namespace brunt::implicit
