// SPDX-License-Identifier: Apache-2.0
// Nodes that lie behind faces which have come to the surface: what they lie inside then is no penetration. Gaps of the
// node with faces of that body are measured from it, and as the node comes out the measure goes with it, so that it
// never is deeper again.
#pragma once
#include <span>
#include <vector>

#include "brunt/contact/data/constraint.hpp"
#include "brunt/contact/data/history.hpp"

namespace brunt::contact {

/// What decides about births besides the rows.
struct BirthScene {
  std::span<const HistoryRecord> acted;  ///< of the last step
  std::span<const NodeMotion> motion;
  double dt = 0;
  bool surface_is_new = false;  ///< elements have gone since rows were last found
};

/// The births of a step with these rows, of which gaps are measured from `births` as they were. Closed rows of faces
/// that did not act in the last step are born: with their penetration where the surface is new; else with what of it
/// neither was there in the last step nor has come about by its motion. (At a torn edge a mass point may lie in front
/// of one face and deep behind the next, and rows of such faces come and go.) A birth is no deeper than the node lies
/// in the body; nothing is left of it where the node meets the body no more. scratch: any, to save allocations.
void follow_births(const BirthScene& scene, std::vector<Row>& rows, std::vector<BirthRecord>& births,
                   std::vector<BirthRecord>& scratch);

}  // namespace brunt::contact
