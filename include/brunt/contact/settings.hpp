// SPDX-License-Identifier: Apache-2.0
// What contact is asked for: as the user gave it, never written to again. What follows from it and from the surface is
// derived once (see DerivedSettings).
#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "brunt/contact/data/options.hpp"
#include "brunt/contact/detection/detection.hpp"
#include "brunt/contact/surface/surface.hpp"

namespace brunt::contact {

/// When lists are rebuilt; no result depends on it.
struct Rebuild {
  enum class When : std::int8_t { motion_used_up, every, random } when = When::motion_used_up;
  int steps = 1;           ///< for `every`, besides when the motion is used up
  std::uint64_t seed = 1;  ///< for `random`, in about one step of four
};

struct ContactSettings {
  PairTable pairs;     ///< of blocks; no blocks: no contact between bodies, walls only
  bool bodies = true;  ///< search for contact between bodies
  DetectionSettings detection;
  std::vector<FrictionLaw> friction;  ///< of pairs of blocks, [a * blocks + b]; empty: none
  std::vector<Tied> tied{};           ///< of pairs of blocks, the same places; empty: none
  std::vector<double> impedance;      ///< density times speed of sound of each block, for Method::printed
  std::vector<double> sound{};        ///< speed of sound of each block [velocity]; empty: see DetectionSettings::sound
  EnforcementSettings enforcement;
  double motion_share = 0.3;  ///< of Surface::mean_depth: how far nodes may move before lists are rebuilt
  /// By block: of two-sided sheets, met at half of it from their faces [length]; 0 or missing: the skin of a solid.
  std::vector<double> thickness{};
  Rebuild rebuild;
  std::vector<std::array<std::int32_t, 2>> tracked;  ///< pairs of blocks whose impulse is summed
};

/// What follows from the settings, the surface and the walls; the same on every rank.
struct DerivedSettings {
  DetectionSettings detection;      ///< complete: lengths of the surface, speeds of bodies, all accepted overlaps
  EnforcementSettings enforcement;  ///< warm_start and averaged as they can be in this scene
  Roles roles;                      ///< of bodies
  bool friction = false;            ///< somewhere, on a wall too
  bool two_passes = false;          ///< of some pair
  bool sheets = false;              ///< two-sided faces exist
  bool may_be_driven = false;       ///< supports hold some node of the surface
  bool remembers = false;           ///< a step depends on the one before: there is a history to save
};

}  // namespace brunt::contact
