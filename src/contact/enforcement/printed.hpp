// SPDX-License-Identifier: Apache-2.0
// The iteration (26) of Heinstein et al. 2000 with H as printed in eq. (29): the impedances of the two bodies and the
// tributary area replace the masses. The slab of eq. (28) is thinner than that of the lumped mass of a surface node by
// twice the Courant number, so near the stability limit an iteration overcorrects by a factor of up to 1.8. On matching
// meshes it leaves a rebound after every even iteration; on coarse slaves it diverges. For comparisons only.
#pragma once
#include "contact/enforcement/enforce.hpp"

namespace brunt::contact {

/// As `enforce`; uses RowFigures::slab, and the row sums for rows that have none.
EnforcementResult enforce_printed(const System& system, const EnforcementSettings& settings, double dt,
                                  Exchange& exchange, std::span<Vec3> impulses, std::span<Vec3> velocity,
                                  EnforcementScratch& scratch);

}  // namespace brunt::contact
