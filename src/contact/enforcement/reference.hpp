// SPDX-License-Identifier: Apache-2.0
// The exact solution of the rate constraint (22) of Heinstein et al. 2000, as a reference for the iterations: by PETSc,
// matrix-free, on all ranks together. Rows that may open form a bound-constrained problem (TAO, limited-memory variable
// metric), completed by conjugate gradients (KSP) on the active rows; if all rows have a free cone, KSP is used alone.
// Its sums over ranks are those of PETSc: the last bits depend on the number of ranks.
#pragma once
#include "contact/enforcement/enforce.hpp"

namespace brunt::contact {

/// As `enforce`; settings.tolerance and max_iterations are not used. Rows with friction are an error (demand):
/// Coulomb's law is not a minimisation. PETSc must be initialised (comm/session.hpp).
EnforcementResult enforce_reference(const System& system, const EnforcementSettings& settings, Exchange& exchange,
                                    std::span<Vec3> impulses, std::span<Vec3> velocity, EnforcementScratch& scratch);

}  // namespace brunt::contact
