// SPDX-License-Identifier: Apache-2.0
// The partitioned kinematic predictor-corrector of Heinstein et al. 2000, eq. (24), (25): the predicted penetration is
// closed with the mass of each row alone, a share beta of it by this pass, and the remainder is corrected once.
#pragma once
#include "contact/enforcement/enforce.hpp"

namespace brunt::contact {

/// As `enforce`.
EnforcementResult enforce_kinematic(const System& system, const EnforcementSettings& settings, double dt,
                                    Exchange& exchange, std::span<Vec3> impulses, std::span<Vec3> velocity,
                                    EnforcementScratch& scratch);

}  // namespace brunt::contact
