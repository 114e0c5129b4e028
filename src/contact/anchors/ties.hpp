// SPDX-License-Identifier: Apache-2.0
// Tied parts: slave nodes that lie on (or slightly off) a face of the other part at the start keep their relative
// position for the whole run. A tie is Coulomb friction without a limit, whose normal also transmits tension, so its
// rows are solved together with all others.
//
// A node at the height h over its face keeps the position x_s = sum w_i x_i + h n, with n the unit area vector of the
// face: it is connected as by a rigid pin perpendicular to the face. The row is the gradient of this condition. A
// common rotation therefore violates nothing, and its impulses have no moment (see Arm). Alternatives: weights over
// the nodes of the element behind the face also preserve moments, but stretch the gap with the element, which overloads
// its layer by h divided by its depth; moving the nodes onto the faces changes the mesh of the user.
#pragma once
#include <functional>
#include <span>
#include <vector>

#include "contact/data/carriers.hpp"
#include "contact/data/mortar_ties.hpp"
#include "contact/detection/detection.hpp"

namespace brunt::contact {

/// A slave node and its position on a master face.
struct Tie {
  GlobalIndex slave = 0;                ///< gid
  GlobalIndex face = 0;                 ///< key
  std::int32_t body = 0, block = 0;     ///< of the face
  std::int32_t slave_block = no_index;  ///< that is tied to it
  std::array<double, 4> weights{};      ///< of the face's corners, sum 1; beside the face some are negative
  double height = 0;                    ///< over the point of these weights, along the face's area vector [length]
};

/// Arms of the row of a tie: of its slave and of the corners of its face.
using TieArms = std::array<Arm, most_nodes_of_a_row>;

/// The ties of a run, for slaves owned here: rows with integrated weights where facets are covered, pins elsewhere.
struct TiedParts {
  std::vector<Tie> ties;                  ///< pins, in ascending order of their slaves
  std::vector<TieArms> arms;              ///< one a pin, of the last step
  MortarTies mortar;                      ///< see mortar_ties.hpp
  std::vector<LocalIndex> mortar_places;  ///< of their terms: contact nodes
  std::vector<Arm> mortar_arms;           ///< of their terms, of the last step
  std::vector<TiedPair> pairs_at_start;   ///< that shared segments at the start, ascending
  std::vector<TiedPair> pairs_in_use;     ///< those that `mortar` is integrated over
  std::vector<GlobalIndex> nodes_beside;  ///< see TiedNodes, of this rank
};

/// Number of nodes of block a that are tied to faces of block b, [a * blocks + b], and number of those that face such a
/// face within reach but lie beside it, and are not tied; empty if no pair is tied.
struct TiedNodes {
  std::vector<GlobalIndex> tied, beside;
};

/// Finds the ties among the candidates, in ascending order of their slaves. Each slave is tied to the nearest face (of
/// equal ones that with the lowest key) that may_tie admits, that its own surface faces (one of its faces, or their
/// sum, within 60 degrees), and that has the slave within the reach of the settings over it and at most their `rim`
/// beside it. may_tie(slave, face): contact node and index of the face. motion: initial positions. faces: of the lists.
/// facet_area: along the area vectors of the slaves' own faces; a slave without faces may be tied in all directions.
/// beside(slave, face) is called for slaves without a tie that face a face within reach but lie beside it.
std::vector<Tie> find_ties(const Candidates& candidates, std::span<const MasterFace> faces,
                           std::span<const GlobalIndex> gid, std::span<const NodeMotion> motion,
                           std::span<const Vec3> facet_area, const Tolerances& tolerances,
                           const std::function<bool(LocalIndex, LocalIndex)>& may_tie,
                           const std::function<void(LocalIndex, LocalIndex)>& beside);

/// Data from which rows of ties are created, other than the ties.
struct TieScene {
  const Candidates& candidates;
  std::span<const MasterFace> faces;
  std::span<const LocalIndex> by_key;  ///< the faces in ascending order of their keys
  std::span<const GlobalIndex> gid;    ///< of contact nodes
  std::span<const NodeMotion> motion;
  double recovery = 0;  ///< share of a drift that a step takes back
  double dt = 0;
};

/// The tie of this slave to this body, or null. ties: in ascending order of their slaves.
const Tie* find_tie(std::span<const Tie> ties, GlobalIndex slave, std::int32_t body);

/// Whether the lists contain the face of a tie and its slave. They do not if the tie is broken.
bool holds(const Tie& tie, const TieScene& scene);

/// Appends a row for each tie: free along the normal, friction without a limit across it. arms: room for those of each
/// tie, with the lifetime of the rows.
void tie_rows(std::span<const Tie> ties, const TieScene& scene, std::span<TieArms> arms, std::vector<Row>& rows);

/// In directions in which no impulse can change the rate of a tie's row (supports constrain all its points), the
/// required rate is set to that of v*. Any other value would come from rounding of positions or contradict the
/// supports, and no iteration could satisfy it. mobility and motion: of contact nodes; carriers: of those on rigid
/// bodies.
void keep_feasible_rate(Row& row, std::span<const Mobility> mobility, std::span<const NodeMotion> motion,
                        const Carriers& carriers = {});

}  // namespace brunt::contact
