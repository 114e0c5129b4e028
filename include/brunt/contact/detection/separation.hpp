// SPDX-License-Identifier: Apache-2.0
// How far candidates are from each other: lists hold what may meet until they are made anew, which in most steps of
// bodies that fly, and of edges and faces of one body near each other, does not.
#pragma once
#include <span>

#include "brunt/contact/detection/detection.hpp"
#include "brunt/contact/detection/edges.hpp"

namespace brunt::contact {

/// As long as no node and no wall moves from where it is by more than a third of this [length], the step included, no
/// candidate of a face, an edge or a wall becomes a row; <= 0 where one may now. Infinite without candidates. reach:
/// of the faces in this step, as detect_faces leaves it in its scratch.
double separation_of_faces(const Candidates& candidates, std::span<const FaceReach> reach,
                           std::span<const NodeMotion> motion, double dt);
double separation_of_edges(const EdgeCandidates& candidates, std::span<const NodeMotion> motion, double dt,
                           const DetectionSettings& settings);
double separation_of_walls(std::span<const WallCandidate> candidates, std::span<const Wall> walls,
                           std::span<const NodeMotion> motion, double dt, const DetectionSettings& settings);

}  // namespace brunt::contact
