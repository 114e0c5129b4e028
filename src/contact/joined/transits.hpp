// SPDX-License-Identifier: Apache-2.0
// The time in which a wave crosses half of the element behind a surface node, h/(2c) [time]: the mass of the node over
// the impedance of what is behind it. For Impact::elastic.
#pragma once
#include <span>
#include <vector>

#include "comm/communicator.hpp"
#include "contact/surface/surface.hpp"

namespace brunt::contact {

/// Of each surface node owned here the longest one of its contact faces, of other nodes 0. h: SurfaceFace's
/// element_depth; sound: speed by block [velocity], infinite for rigid ones, whose nodes have 0. Collective.
std::vector<double> transits(const comm::Communicator& ranks, const Surface& surface, std::span<const double> sound);

}  // namespace brunt::contact
