// SPDX-License-Identifier: Apache-2.0
// Nodes behind faces that have just become exterior: their initial depth is not a penetration. Gaps of such a node with
// faces of that body are measured from this depth. The depth decreases as the node moves out, and never increases
// again.
#pragma once
#include <span>
#include <vector>

#include "contact/data/constraint.hpp"
#include "contact/data/history.hpp"

namespace brunt::contact {

/// Data other than the rows that determine births.
struct BirthScene {
  std::span<const HistoryRecord> acted;  ///< of the last step
  std::span<const NodeMotion> motion;
  double dt = 0;
  bool surface_is_new = false;  ///< elements have gone since rows were last found
  bool only_approach = false;   ///< motion along a face explains no depth: mortar rows held mean gaps until now
};

/// The births of a step with these rows, whose gaps are measured from the previous `births`. A closed row of a face
/// that did not act in the last step creates a birth: with its penetration if the surface is new, otherwise with the
/// part of the penetration that neither existed in the last step nor results from its motion. (At a torn edge a mass
/// point may lie in front of one face and deep behind the next, and rows of such faces appear and disappear.) A birth
/// is never deeper than the node lies in the body, and is deleted when the node no longer touches the body. scratch:
/// any, to save allocations.
void follow_births(const BirthScene& scene, std::vector<Row>& rows, std::vector<BirthRecord>& births,
                   std::vector<BirthRecord>& scratch);

}  // namespace brunt::contact
