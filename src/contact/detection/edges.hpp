// SPDX-License-Identifier: Apache-2.0
// Edge-to-edge contact: where two sharp edges cross, no node need be near a face.
#pragma once
#include <array>
#include <limits>
#include <span>
#include <vector>

#include "contact/data/constraint.hpp"
#include "contact/detection/detection.hpp"
#include "core/ragged.hpp"

namespace brunt::contact {

/// An edge among the contact nodes.
struct ContactEdge {
  std::array<LocalIndex, 2> nodes{};   ///< contact nodes, lower gid first
  std::array<LocalIndex, 2> facets{};  ///< the two faces that meet in it: rows of the facet area vectors
  std::int32_t body = 0, block = 0;
  double element_depth = std::numeric_limits<double>::infinity();  ///< the smaller one of its two faces [length]
  bool flat = false;                                               ///< lies within a face of its body: see EdgeKind
  std::array<bool, 2> seam{};                                      ///< of each facet, see SurfaceEdge
  std::array<char, 2> end_on_rim{};                  ///< of a flat one: 1 where that end stands on a sharp edge
  std::array<std::array<bool, 2>, 2> end_at_side{};  ///< of each end, of each facet, see SurfaceEdge
};

/// The first row of a contact node with a face in this step.
struct NodeHold {
  Vec3 normal = Vec3::Zero();  ///< zero: there is none
  double body = no_index;      ///< whose face it is; a number like the others, to be shared between ranks

  [[nodiscard]] bool is_on(std::int32_t other) const { return body == other; }
};
constexpr int hold_width = sizeof(NodeHold) / sizeof(double);

/// Candidate pairs, slave edge by slave edge in ascending (gid, gid).
struct EdgeCandidates {
  std::vector<ContactEdge> slaves, masters;
  Ragged<LocalIndex> near;  ///< a row for each slave edge: master edges in ascending (gid, gid)
};

/// The pairs of edges, and what else decides about them.
struct EdgeInput {
  const EdgeCandidates& candidates;
  std::span<const Vec3> facet_normal{};  ///< unit
  std::span<const NodeHold> holds{};     ///< of each contact node, the same on every copy
  /// Initial positions of the contact nodes, from which edges have their accepted overlaps; empty if the settings
  /// accept none.
  std::span<const Vec3> reference{};
  std::span<const HeldBodies> held{};  ///< of each contact node: by mortar rows; empty: there are none
};

/// Appends a row for two edges that touch, come into contact in this step, or are so close that the impulses of the
/// step may bring them into contact. The normal is the common perpendicular, out of the master. It must lie between the
/// normals of the two faces of either edge (otherwise a face or a node is in contact). The order of the passes, for
/// each pair whose swept boxes overlap, unless mortar rows with the other body hold both ends of one of them:
///
/// 1. The crossing. A flat edge crosses rims only (flat_edges.hpp). Sharp edges are in contact, near each other, or
///    their paths cross within the step.
/// 2. Edges that slide over a ledge have no row (edge_ledges.hpp).
/// 3. A sharp slave edge has no row if its ends hold it: both ends, or the end at which the edges cross, have rows of
///    their own with the other body along nearly the same normal.
/// 4. A sharp edge that lies on a face of the other one meets it along the normal of that face (face_below).
/// 5. At the lateral face of a seam there is no row (seams.hpp).
/// 6. The gap is measured from an accepted overlap, and the row receives its required rate.
void detect_edges(const StepView& step, const EdgeInput& input, std::vector<Row>& rows);

}  // namespace brunt::contact
