// SPDX-License-Identifier: Apache-2.0
// Anchors of sticking nodes: their present positions, and new ones. An anchor moves with the face on which it lies,
// even when the slave has moved to another face. It is dropped by a geometric criterion only, before its face can leave
// the candidate lists.
#pragma once
#include <optional>
#include <span>
#include <vector>

#include "contact/data/history.hpp"
#include "contact/detection/detection.hpp"

namespace brunt::contact {

/// The data on which anchors depend.
struct AnchorScene {
  std::span<const MasterFace> faces;
  std::span<const LocalIndex> by_key;  ///< the faces in ascending order of their keys
  std::span<const NodeMotion> motion;  ///< of contact nodes
  std::span<const Wall> walls;
  const Tolerances* tolerances = &standard_tolerances;
};

/// Called once for each list.
std::vector<LocalIndex> order_by_key(std::span<const MasterFace> faces);

/// The face of this key, or null. by_key: the faces in ascending order of their keys.
const MasterFace* find_face(std::span<const MasterFace> faces, std::span<const LocalIndex> by_key, GlobalIndex key);

/// Distance of the row's slave from its anchor [length], at x_n. Empty if the anchor lies on a face and is farther from
/// the slave than the reach of the settings (and half the thickness of the face). The anchor is then dropped, on every
/// rank and independent of the lists, since lists contain all nearer faces. For edges it is the distance between the
/// points of first contact.
std::optional<Vec3> slip(const AnchorScene& scene, const AnchorRecord& anchor, const Row& row);

/// An anchor at the present contact point of the row's slave and master.
AnchorRecord anchor_of(const AnchorScene& scene, const Row& row);

/// The anchor of a row at its limit, which its slave drags along as far as it slid within the step [length]. Empty if
/// it would leave its face, and for edges.
std::optional<AnchorRecord> dragged(const AnchorScene& scene, const AnchorRecord& anchor, const Row& row,
                                    const Vec3& slid);

}  // namespace brunt::contact
