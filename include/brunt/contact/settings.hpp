// SPDX-License-Identifier: Apache-2.0
// What contact is asked for: as the user gave it, never written to again. What follows from it and from the surface is
// derived once (see DerivedSettings).
#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "brunt/contact/data/specification.hpp"
#include "brunt/contact/detection/detection.hpp"
#include "brunt/contact/surface/surface.hpp"

namespace brunt::contact {

/// By block; of arrays that are too short, the rest is 0.
struct BlockProperties {
  std::vector<double> impedance{};  ///< density times speed of sound, for Method::printed
  std::vector<double> sound{};      ///< speed of sound [velocity]; empty: see DetectionSettings::sound
  std::vector<double> thickness{};  ///< of two-sided sheets, met at half of it from their faces [length]; 0: of a solid
};

/// Contact whose impulses are summed: of a block with another one, with itself, or, without `other`, with all others.
struct TrackedContact {
  std::int32_t block = 0;
  std::optional<std::int32_t> other{};
};

/// A node that a rigid body carries.
struct BodyNode {
  LocalIndex node = 0;  ///< local node of the mesh
  LocalIndex body = 0;
};

/// Rigid bodies of the model.
struct RigidBodies {
  std::size_t count = 0;          ///< on all ranks
  bool supported = false;         ///< supports hold or drive some of them
  std::vector<BodyNode> nodes{};  ///< of this rank
};

struct ContactSettings {
  Specification specification;
  BlockProperties blocks;
  DetectionSettings detection;  ///< but for what is derived
  double motion_share = 0.3;    ///< of Surface::mean_element_depth: how far nodes may move before lists are rebuilt
  RigidBodies rigid{};
  std::vector<TrackedContact> tracked;
  bool erodes = false;          ///< elements may go: nodes may be born inside
  bool wall_pressures = false;  ///< `pressures` are asked for on walls: areas around nodes near walls are kept
};

/// What follows from the settings, the surface and the walls; the same on every rank.
struct DerivedSettings {
  DetectionSettings detection;      ///< complete: lengths of the surface, speeds of bodies, all accepted overlaps
  EnforcementSettings enforcement;  ///< warm_start and averaged as they can be in this scene
  Roles roles;                      ///< of bodies
  bool bodies = false;              ///< search for contact between bodies: else walls only
  bool tied = false;                ///< some pair is tied
  bool friction = false;            ///< somewhere, on a wall too
  bool two_passes = false;          ///< of some pair
  bool sheets = false;              ///< two-sided faces exist
  bool may_be_driven = false;       ///< supports hold some node of the surface
  bool remembers = false;           ///< a step depends on the one before: there is a history to save
};

}  // namespace brunt::contact
