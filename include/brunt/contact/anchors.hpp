// SPDX-License-Identifier: Apache-2.0
// Anchors of sticking nodes in this step: where they are now, and new ones. An anchor moves with the face that holds
// it, also when the slave has come to lie over another; it is dropped by geometry alone, before its face may leave the
// lists.
#pragma once
#include <optional>
#include <span>
#include <vector>

#include "brunt/contact/data/history.hpp"
#include "brunt/contact/detection/detection.hpp"

namespace brunt::contact {

/// What anchors hang on.
struct AnchorScene {
  std::span<const MasterFace> faces;
  std::span<const LocalIndex> by_key;  ///< the faces in ascending order of their keys
  std::span<const NodeMotion> motion;  ///< of contact nodes
  std::span<const Wall> walls;
  const Tolerances* tolerances = &standard_tolerances;
};

/// Once a list.
std::vector<LocalIndex> order_by_key(std::span<const MasterFace> faces);

/// The face of this key, or null. by_key: the faces in ascending order of their keys.
const MasterFace* find_face(std::span<const MasterFace> faces, std::span<const LocalIndex> by_key, GlobalIndex key);

/// How far the row's slave has moved off its anchor [length], at x_n. Nothing where it lies on a face and is farther
/// from the slave than the settings' reach (and half the face's thickness): then it is dropped, on every rank and
/// whatever the lists hold, for lists hold all faces that are nearer. Of edges it is the points that met at first which
/// have come apart.
std::optional<Vec3> slip(const AnchorScene& scene, const AnchorRecord& anchor, const Row& row);

/// An anchor where the row's slave meets its master now.
AnchorRecord anchor_of(const AnchorScene& scene, const Row& row);

}  // namespace brunt::contact
