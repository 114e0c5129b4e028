// SPDX-License-Identifier: Apache-2.0
// Parts that hold together: slave nodes that lie on (or just off) a face of the other part at the start keep their
// place against it for the whole run. A tie is Coulomb friction without limit whose normal pulls as well as pushes, so
// its rows are solved with all the others.
#pragma once
#include <functional>
#include <span>
#include <vector>

#include "brunt/contact/detection/detection.hpp"

namespace brunt::contact {

/// A slave node and its place on a master face.
struct Tie {
  GlobalIndex slave = 0;                ///< gid
  GlobalIndex face = 0;                 ///< key
  std::int32_t body = 0, block = 0;     ///< of the face
  std::int32_t slave_block = no_index;  ///< that is tied to it
  std::array<double, 4> weights{};      ///< of the face's corners
  bool flush = true;                    ///< the node lies on its face, but for a thousandth of the face's longest edge
  Vec3 offset = Vec3::Zero();           ///< from there to the node, in the frame of the face [length]
};

/// The axes of a face that offsets are measured in, as columns: two in it and its normal.
Mat3 face_frame(std::span<const Vec3> corners);

/// Finds the ties among the candidates, in ascending order of their slaves: each slave with the nearest face (of equals
/// the lowest key) that it may be tied to, within the settings' reach of it in its plane or out of it.
/// may_tie(slave, face): contact node and index of the face. motion: positions of the start. faces: of the lists.
std::vector<Tie> find_ties(const Candidates& candidates, std::span<const MasterFace> faces,
                           std::span<const GlobalIndex> gid, std::span<const NodeMotion> motion,
                           const EncounterSettings& settings,
                           const std::function<bool(LocalIndex, LocalIndex)>& may_tie);

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

/// Appends a row a tie: free along the normal, friction without limit across it.
void tie_rows(std::span<const Tie> ties, const TieScene& scene, std::vector<Row>& rows);

}  // namespace brunt::contact
