// SPDX-License-Identifier: Apache-2.0
// Parts that hold together: slave nodes that lie on (or just off) a face of the other part at the start keep their
// place against it for the whole run. A tie is Coulomb friction without limit whose normal pulls as well as pushes, so
// its rows are solved with all the others.
//
// A node at the height h over its face keeps the place x_s = sum w_i x_i + h n, with n the unit area vector of the
// face: the two are as if joined by a rigid pin that stands on the face. The row is the gradient of that, so that a
// turn of all together asks for nothing and its impulses have no moment (see Lever). Against the other cures: weights
// over the nodes of the element behind the face keep moments as well, but stretch the gap with the element, which
// overloads its layer by h over its depth; moving the nodes onto the faces changes the mesh that was asked for.
#pragma once
#include <functional>
#include <span>
#include <vector>

#include "brunt/contact/data/carriers.hpp"
#include "brunt/contact/detection/detection.hpp"

namespace brunt::contact {

/// A slave node and its place on a master face.
struct Tie {
  GlobalIndex slave = 0;                ///< gid
  GlobalIndex face = 0;                 ///< key
  std::int32_t body = 0, block = 0;     ///< of the face
  std::int32_t slave_block = no_index;  ///< that is tied to it
  std::array<double, 4> weights{};      ///< of the face's corners, sum 1; a little beside the face some are negative
  double height = 0;                    ///< over the point that they name, along the face's area vector [length]
};

/// The ties of a run, of slaves owned here.
struct TiedParts {
  std::vector<Tie> ties;                  ///< in ascending order of their slaves
  std::vector<Lever> levers;              ///< one a tie, of the last step
  std::vector<GlobalIndex> nodes_beside;  ///< see TiedNodes, of this rank
};

/// How many nodes of block a are tied to faces of block b, [a * blocks + b], and how many look at such a face within
/// reach but lie beside it, and are not; empty where no pair is tied.
struct TiedNodes {
  std::vector<GlobalIndex> tied, beside;
};

/// Finds the ties among the candidates, in ascending order of their slaves: each slave with the nearest face (of equals
/// the lowest key) that it may be tied to, that its own surface looks at (one face of it, or their sum, by 60 degrees
/// or less), and that has it within the settings' reach over it and at most their `rim` beside it. may_tie(slave,
/// face): contact node and index of the face. motion: positions of the start. faces: of the lists. facet_area: along
/// the area vectors of the slaves' own faces; slaves that have none look everywhere. beside(slave, face) is called for
/// slaves without a tie that look at a face within reach, but lie beside it.
std::vector<Tie> find_ties(const Candidates& candidates, std::span<const MasterFace> faces,
                           std::span<const GlobalIndex> gid, std::span<const NodeMotion> motion,
                           std::span<const Vec3> facet_area, const Tolerances& tolerances,
                           const std::function<bool(LocalIndex, LocalIndex)>& may_tie,
                           const std::function<void(LocalIndex, LocalIndex)>& beside);

/// What rows of ties are made from, besides the ties.
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

/// Do the lists hold the face of a tie and its slave? Not where the parts have been torn from each other.
bool holds(const Tie& tie, const TieScene& scene);

/// Appends a row a tie: free along the normal, friction without limit across it. levers: room for one a tie, to live as
/// long as the rows.
void tie_rows(std::span<const Tie> ties, const TieScene& scene, std::span<Lever> levers, std::vector<Row>& rows);

/// Along directions in which no impulse can change the rate of a tie's row (supports hold its slave and all corners of
/// its face there) the row shall ask for the rate that it has by v*: so for nothing. What else it asked for would be
/// the rounding of positions, or a contradiction of the supports, and no iteration could satisfy it. mobility and
/// motion: of contact nodes; carriers: of those on rigid bodies.
void keep_feasible_rate(Row& row, std::span<const Mobility> mobility, std::span<const NodeMotion> motion,
                        const Carriers& carriers = {});

}  // namespace brunt::contact
