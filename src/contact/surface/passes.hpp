// SPDX-License-Identifier: Apache-2.0
// Two-pass contact: nodes of either side on faces of the other. The rate constraint imposes all rows in one system. It
// has more rows than the surfaces have degrees of freedom, so its impulses are not unique. The velocities are (the
// smallest change of v* that satisfies all rows), and so is the impulse on each node. No locking was observed: rows
// only transmit compression, so some of them open where the surfaces bend. Uniform pressure is transmitted exactly by
// rigid rows if the meshes are aligned (Taylor and Papadopoulos 1991), unlike with one pass or the mean of two; and
// contact does no work except that of recovery, whereas a mean of two solutions opens in one pass what the other
// closes.
//
// The rows of the two sides are nearly redundant: the system has eigenvalues of 1e-5 of the largest one on fine meshes,
// and rigid rows need a number of iterations that grows with the contact area. By default rows between deformable
// bodies are nevertheless rigid (EnforcementSettings::softness = 0), and rows between rigid bodies have a softness of
// 0.05 (softness_of_bodies). A `softness` given in a scene also applies to rows of a single pass. It bounds the
// eigenvalues from below (enforcement/softness.hpp), and causes an error of uniform pressure (table in cases/README.md,
// "Softness of contact"). Penalties, the kinematic predictor and the printed method would act twice, so they use the
// mean of both passes (see enforcement/averaged.hpp).
#pragma once
#include <span>

#include "contact/data/constraint.hpp"
#include "contact/surface/surface.hpp"

namespace brunt::contact {

/// The pass of a row between a node and a face (not an edge or a wall). Between bodies, rows of the primary slave form
/// the first pass. Within a body no side is finer, and the numbers of the nodes decide: the slave's, and master_gid,
/// the lowest of the face. Where two folds touch, nodes of one on faces of the other form the first pass and the others
/// the second, provided that the mesh is numbered fold by fold. The choice is independent of directions in space.
Pass pass_of(const Row& row, const SurfaceNode& node, GlobalIndex master_gid, const Specification& specification,
             std::span<const BodyFigures> bodies);

}  // namespace brunt::contact
