// SPDX-License-Identifier: Apache-2.0
// Settings of contact: as given by the user, and constant. Quantities that follow from them and from the surface are
// derived once (see DerivedSettings).
#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "contact/data/specification.hpp"
#include "contact/detection/detection.hpp"
#include "contact/surface/surface.hpp"

namespace brunt::contact {

/// By block; of arrays that are too short, the rest is 0.
struct BlockProperties {
  std::vector<double> impedance{};  ///< density times speed of sound, for Method::printed
  std::vector<double> sound{};      ///< speed of sound [velocity]; empty: see DetectionSettings::sound
  std::vector<double>
      thickness{};  ///< of two-sided sheets, whose contact surfaces are half of it from the faces [length]; 0: a solid
};

/// Contact whose impulses are summed: of a block with another one, with itself, or, without `other`, with all others.
struct TrackedContact {
  std::int32_t block = 0;
  std::optional<std::int32_t> other{};
};

/// A node of a rigid body.
struct BodyNode {
  LocalIndex node = 0;  ///< local node of the mesh
  LocalIndex body = 0;
};

/// Rigid bodies of the model.
struct RigidBodies {
  std::size_t count = 0;          ///< on all ranks
  bool supported = false;         ///< supports hold or drive some of them
  bool squeezed = false;          ///< something that cannot yield moves: drives of any nodes or bodies, moving walls
  std::vector<double> extent{};   ///< shortest side of each at the start [length]
  std::vector<BodyNode> nodes{};  ///< of this rank
};

struct ContactSettings {
  Specification specification;
  BlockProperties blocks;
  DetectionSettings detection;  ///< but for what is derived
  double motion_share = 0.3;    ///< of Surface::mean_element_depth: admissible motion of nodes until lists are rebuilt
  RigidBodies rigid{};
  std::vector<TrackedContact> tracked;
  SearchMethod search = SearchMethod::automatic;
  bool erodes = false;          ///< elements may be removed: nodes may initially lie inside
  bool wall_pressures = false;  ///< `pressures` are needed on walls: areas around nodes near walls are kept
};

/// Quantities derived from the settings, the surface and the walls; equal on every rank.
struct DerivedSettings {
  DetectionSettings detection;      ///< complete: lengths of the surface, speeds of bodies, all accepted overlaps
  EnforcementSettings enforcement;  ///< warm_start and averaged as far as they apply to this scene
  Roles roles;                      ///< of bodies
  bool bodies = false;              ///< search for contact between bodies; otherwise walls only
  bool tied = false;                ///< some pair is tied
  bool friction = false;            ///< somewhere, on a wall too
  bool two_passes = false;          ///< of some pair
  bool mortar = false;              ///< some pair has mortar rows
  bool sheets = false;              ///< two-sided faces exist
  bool elastic_impact = false;      ///< Impact::elastic
  bool may_be_driven = false;       ///< supports hold some node of the surface, or may_jam
  bool may_jam = false;             ///< rigid bodies may be driven where they have no way out
  bool remembers = false;           ///< a step depends on the previous one: there is a history to save
};

}  // namespace brunt::contact
