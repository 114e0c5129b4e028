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

/// The surface is new: of the rows of faces just found, those closed ones that did not act in the last step are born
/// with their penetration.
void begin_births(std::span<const HistoryRecord> acted, std::vector<Row>& rows, std::vector<BirthRecord>& births);

/// What is left of the births after a step with these rows: no more than how deep the node still is; nothing where it
/// meets the body no more.
void fade_births(std::span<const Row> rows, std::vector<BirthRecord>& births);

}  // namespace brunt::contact
