// SPDX-License-Identifier: Apache-2.0
// Rows of ties with integrated weights (TIES.md). A row keeps
//   sum_k w_k x_k = sum_f h_f n_f,
// the weighted places of both sides against the pins h_f that stand on the unit normals n_f of the slave facets around
// its node. The row is the gradient of this condition; what has crept is turned with the facets. So a common rotation
// violates nothing, and the impulses have no moment.
#pragma once
#include <span>
#include <vector>

#include "contact/data/carriers.hpp"
#include "contact/data/constraint.hpp"
#include "contact/data/mortar_ties.hpp"

namespace brunt::contact {

/// Data from which the rows are created. places: of all terms, contact nodes.
struct MortarTieScene {
  const MortarTies& ties;
  std::span<const LocalIndex> places;
  std::span<const NodeMotion> motion;
  std::span<const Mobility> mobility;  ///< of contact nodes
  Carriers carriers;
  double recovery = 0;  ///< share of a drift that a step takes back
  double dt = 0;
};

/// The row of the node with this body, or null.
const MortarTie* find_mortar_tie(const MortarTies& ties, const RowKey& key);

/// Whether the node is one of a facet that this body covers: nothing else acts between the two.
bool is_held(const MortarTies& ties, GlobalIndex node, std::int32_t body);

/// Whether a row's places are farther apart than their pins and an edge together. positions: of contact nodes.
bool are_torn(const MortarTies& ties, std::span<const LocalIndex> places, std::span<const Vec3> positions);

/// Appends a row for each tie: free along the normal, held across it. In directions in which supports hold both the
/// node and the place below it, the row asks for nothing: it would constrain the master's other nodes. arms: room for
/// one for each term, with the lifetime of the rows.
void append_mortar_ties(const MortarTieScene& scene, std::span<Arm> arms, std::vector<Row>& rows);

}  // namespace brunt::contact
