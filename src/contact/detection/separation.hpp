// SPDX-License-Identifier: Apache-2.0
// Distance between candidates. Lists contain everything that may touch until they are rebuilt. In most steps of bodies
// in flight, and of edges and faces of one body close to each other, nothing touches.
#pragma once
#include <span>

#include "contact/detection/detection.hpp"
#include "contact/detection/edges.hpp"

namespace brunt::contact {

/// As long as no node or wall moves from its position by more than a third of this [length], including this step, no
/// candidate of a face, an edge or a wall becomes a row; <= 0 if one may now. Infinite without candidates. reach: of
/// the faces in this step, as returned by detect_faces in its scratch.
double separation_of_faces(const StepView& step, const Candidates& candidates, std::span<const FaceReach> reach);
double separation_of_edges(const StepView& step, const EdgeCandidates& candidates);
double separation_of_walls(const StepView& step, std::span<const WallCandidate> candidates,
                           std::span<const Wall> walls);

}  // namespace brunt::contact
