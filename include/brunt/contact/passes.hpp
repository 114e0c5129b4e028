// SPDX-License-Identifier: Apache-2.0
// Contact in two passes: nodes of either side on faces of the other. Both held exactly would leave the surfaces no
// freedom (nearly every one of their nodes is constrained), so each pass is solved by itself and the mean is taken:
// beta = 1/2 of Heinstein et al. 2000, eq. (24), with the rate constraint in place of the predictor. The mean leaves
// some approach where the passes disagree; what becomes of it is asked back as a gap (see `recover_gaps`).
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

struct GapFeedback {
  double recovery = 1;  ///< share of a penetration that its pass recovers in a step; half of it is left by the mean
};

/// Row::required of the closed rows of one pass: where bodies press on each other the passes disagree in every step, by
/// a share of what contact has to hold off, n . G v*. So up to that rate the penetration is asked back, above the slow
/// recovery that all rows have.
void recover_gaps(std::span<Row> rows, std::span<const NodeMotion> motion, const GapFeedback& feedback, double dt);

}  // namespace brunt::contact
