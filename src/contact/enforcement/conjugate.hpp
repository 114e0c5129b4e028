// SPDX-License-Identifier: Apache-2.0
// The rate constraint without sliding friction, by conjugate residuals on the active rows.
//
// Two passes have more rows than the surfaces have degrees of freedom: rows of one side are nearly sums of rows of the
// other, so the system is ill-conditioned. Scaled by row sums, half of the eigenvalues of G W G^T lie in [0.3, 1] (the
// sides separate), the others extend down to 1e-3 .. 1e-5 (both sides move together, with a curvature that the faces of
// one side cannot follow). Methods that use only the last step converge slowly there. For a fixed set of active rows
// the system is linear, and conjugate residuals (Stiefel 1955) need the smallest number of products for a given
// residual. In impacts of steel blocks with non-matching meshes they need 15 to 32 % fewer iterations in the mean than
// Barzilai-Borwein steps. Most iterations occur while rows that will open are still active: the residual then stagnates
// until their impulses, along the weakest direction, have become tensile.
//
// Tried without gain: conjugate gradients, with or without smoothing; steps of Nesterov and of NNCG; Barzilai-Borwein
// steps chosen by their ratio; other diagonals; coarse spaces of polynomials and of pairs of rows. Inverses of small
// overlapping patches of rows reduce the iterations by half and more, but need a second exchange in each iteration, and
// their set-up costs more operations than they save. Compliant rows (softness.hpp; optional) raise the small
// eigenvalues, so that fine meshes need as many iterations as coarse ones.
//
// Each iteration is one product with G W G^T and one reduction, of two kinds:
// - a sweep p <- admitted(p + alpha missing / H), which determines the active rows: those with compression after it;
// - a step of conjugate residuals over these rows, scaled by H: impulses may become tensile temporarily.
// The next kind is chosen by comparing, over all rows, the sweep of length 1 with its linear part on the active rows.
// If rows in tension, or rows that should become active, contribute half of the remainder, a sweep follows (as in the
// proportioning of Dostal, Optimal Quadratic Programming Algorithms, 2009, except that iterates may leave the
// admissible set: each step then costs one product, and rows near the boundary of contact do not restart it one by
// one).
//
// If rows require more than their nodes can provide together (for example edges of a rim over each other's neighbours),
// the residual of the active rows stagnates, and the next step goes a hundred lengths and more along a direction that
// hardly changes the velocities, until most rows are in tension. Such a step ends where the first row becomes tensile,
// and the following sweep releases it. The same applies to a step after which the inactive share is a hundred times the
// rest. A sweep of length 1 ends the iteration.
//
// With Coulomb friction and rigid bodies, sticking rows are active as a whole, and sliding rows by their derivative
// (src/contact/enforcement/chosen_rows.hpp). This matrix is not symmetric, but few rows slide among bodies that rest or
// roll. Stacks of rigid boxes at rest need 25 to 60 % of the iterations of Barzilai-Borwein steps. Deformable bodies
// gain nothing; Barzilai-Borwein steps are used for them.
#pragma once
#include "contact/enforcement/enforce.hpp"

namespace brunt::contact {

/// Data of a system that all ranks know before it is solved.
struct Setting {
  double violation = 0;  ///< by v* [velocity]
  double impulse = 0;    ///< largest impulse of the start on a node [momentum]
  double share = 1;      ///< upper bound of the factor between a row's impulse and that on a node
  double friction = 0;   ///< largest coefficient
  double lagging = 0;    ///< largest impulse across the normal beside that [momentum]
  bool rubs = false;     ///< rows with Coulomb friction
  bool holds = false;    ///< rows that are tied
};

/// Requires consistent impulses and velocities, and scratch.diagonal of row sums; coupled: for this rank's rows, see
/// form_row_sums. Collective.
EnforcementResult iterate_conjugate(const System& system, const EnforcementSettings& settings, const Setting& setting,
                                    bool coupled, Exchange& exchange, std::span<Vec3> impulses,
                                    std::span<Vec3> velocity, EnforcementScratch& scratch);

}  // namespace brunt::contact
