// SPDX-License-Identifier: Apache-2.0
// Contact in two passes: nodes of either side on faces of the other. The rate constraint holds all of them in one
// system. It has more rows than the surfaces have freedom, so its impulses are not unique; the velocities are (the
// least change of v* that no row forbids), and so is what each node is given. None was seen to lock: as rows only push,
// some let go where the surfaces bend. Even pressure passes from mesh to mesh exactly by rigid rows where they line up
// (Taylor and Papadopoulos 1991), which neither one pass nor the mean of two does; and contact does no work but that of
// recovery, while a mean of two solutions pushes open in one what the other closes. What tells the rows of the two
// sides apart are weak eigenvalues, 1e-5 of the largest on fine meshes: rigid rows take iterations that grow with the
// patch. By default rows between deformable bodies are rigid all the same (EnforcementSettings::softness = 0), and rows
// between rigid bodies have a softness of 0.05 (softness_of_bodies). Where a scene gives a `softness`, rows that hold
// in one of the two passes alone have it too: that bounds the eigenvalues from below (enforcement/softness.hpp), and
// even pressure errs by 1 to 2.4 % with 0.05 (table in cases/README.md, "Softness of contact"). Penalties, the
// kinematic predictor and the printed method, which would push twice, take the mean of both passes (see
// enforcement/averaged.hpp).
#pragma once
#include <span>

#include "brunt/contact/data/constraint.hpp"
#include "brunt/contact/surface/surface.hpp"

namespace brunt::contact {

/// The pass of a row between a node and a face (no edge, no wall). Between bodies those that lead are the first. Within
/// a body no side is the finer one: it is told by the numbers of the nodes, the slave's and master_gid, the lower of
/// the face. Where two folds meet, nodes of the one on faces of the other are the first pass and the others the second,
/// as far as the mesh is numbered fold by fold; no direction of space decides.
Pass pass_of(const Row& row, const SurfaceNode& node, GlobalIndex master_gid, const Specification& specification,
             std::span<const BodyFigures> bodies);

}  // namespace brunt::contact
