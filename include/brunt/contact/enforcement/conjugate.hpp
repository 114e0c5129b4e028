// SPDX-License-Identifier: Apache-2.0
// The rate constraint without sliding friction, by conjugate residuals on the rows that push. Two passes hold more rows
// than the surfaces have freedom: rows of the one side are nearly sums of rows of the other, and what separates them
// comes out slowly in steps that know one step before: scaled by row sums half of the eigenvalues of G W G^T lie in
// [0.3, 1] (the sides move apart), the others go down to 1e-3 .. 1e-5 (both move alike, with a curvature that one
// side's faces cannot follow). On a fixed set of rows the system is linear, and conjugate residuals (Stiefel 1955) take
// the least number of products with it that leaves a given residual. Impacts of steel blocks, two passes, mean and most
// to 1e-3: 16:16 elements turned by 30 degrees 17 and 61 (Barzilai-Borwein 20 and 60; were the set known, 12 and 28),
// 8:12 by 10 degrees 24 and 60 (31 and 73; 15 and 27), 20:13 in line 23 and 53 (34 and 95). Most are taken where rows
// that are to let go are still among the chosen: what is left then stands still until their impulses, along the weakest
// direction, have fallen below zero. Conjugate gradients, alone or smoothed, find them no sooner; nor do steps of
// Nesterov's, of NNCG, or Barzilai-Borwein steps chosen by their ratio. Other diagonals, coarse spaces of polynomials
// and pairs of rows scale no better; inverses of small overlapping patches of rows do (5 to 9 with the set known), but
// take a second exchange in each iteration, and by count of operations cost more to set up than they save. Soft rows
// (softness.hpp; by choice) lift the weak end: as many iterations on fine patches as on coarse ones. Figures here are
// of rigid rows. Each
// iteration is one product with G W G^T and one reduction, of two kinds:
// - a sweep p <- admitted(p + alpha missing / H), which chooses the rows anew: those that push after it;
// - a step of conjugate residuals over these rows, scaled by H: impulses may become pulls on the way.
// Which one comes next is decided by comparing, over all rows, the sweep of length 1 with its linear part on the chosen
// rows: where rows pull or ask to push and their share is half of the rest, a sweep is due (as in the proportioning of
// Dostal, Optimal Quadratic Programming Algorithms, 2009, but for the iterates, which may leave the admitted set: each
// step then costs one product, and rows near the border of contact do not restart it one by one).
// Where rows ask for more than their nodes can give together (edges of a rim over each other's neighbours do), what the
// chosen rows leave stands still, and the next step goes a hundred lengths and more along what hardly changes any
// velocity, until most of them pull. Such a step ends where the first row begins to pull, which is let go by the sweep
// after it; so does one after which the share that is not of the chosen rows is a hundred times the rest. (Elastic bars
// that meet edge on edge: 28 iterations at most for 121, and 35 for 197; the impacts above are the same.)
// A sweep of length 1 ends it.
// With Coulomb friction and rigid bodies rows that stick are chosen as a whole, rows that slide by their derivative
// (src/contact/enforcement/chosen_rows.hpp), which is not symmetric, but among bodies that rest or roll few slide.
// Stacks of 2, 6, 10 boxes at rest, soft rows, until 0.03 are left of a start: 8, 24, 24 iterations a step
// (Barzilai-Borwein 31, 68, 40); 8, 55, 83 with the friction of sliding rows left as it was until the next sweep, 8,
// 59, 25 with what follows the normal alone. Deformable bodies gain nothing (a stack of cubes 5.0 for 4.2, a pile 11.4
// for 11.0): there Barzilai-Borwein it is.
#pragma once
#include "brunt/contact/enforcement/enforce.hpp"

namespace brunt::contact {

/// What all ranks know of a system before it is solved.
struct Setting {
  double violation = 0;  ///< by v* [velocity]
  double impulse = 0;    ///< largest impulse of the start on a node [momentum]
  double share = 1;      ///< no node takes more than this times a row's impulse
  double friction = 0;   ///< largest coefficient
  double lagging = 0;    ///< largest impulse across the normal beside that [momentum]
  bool rubs = false;     ///< rows with Coulomb friction
  bool holds = false;    ///< rows that are tied
};

/// From impulses and velocities that belong together and scratch.diagonal of row sums; coupled: of this rank's rows,
/// see form_row_sums. Collective.
EnforcementResult iterate_conjugate(const System& system, const EnforcementSettings& settings, const Setting& setting,
                                    bool coupled, Exchange& exchange, std::span<Vec3> impulses,
                                    std::span<Vec3> velocity, EnforcementScratch& scratch);

}  // namespace brunt::contact
