// SPDX-License-Identifier: Apache-2.0
// Contact in two passes: nodes of either side on faces of the other. Both held exactly would leave the surfaces no
// freedom (nearly every one of their nodes is constrained), so each pass is solved by itself and the mean is taken:
// beta = 1/2 of Heinstein et al. 2000, eq. (24), with the rate constraint in place of the predictor (see
// enforcement/averaged.hpp).
#pragma once
#include <span>

#include "brunt/contact/constraint.hpp"
#include "brunt/contact/surface/surface.hpp"

namespace brunt::contact {

/// The pass of a row between a node of these blocks and a face (no edge, no wall). Between bodies those that lead (see
/// is_slave) are the first. Within a body it is the side that the normal looks to: opposite folds have opposite
/// normals.
Pass pass_of(const Row& row, std::span<const std::int32_t> node_blocks, const PairTable& pairs,
             std::span<const BodyFigures> bodies);

}  // namespace brunt::contact
