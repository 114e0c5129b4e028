// SPDX-License-Identifier: Apache-2.0
// Coordinate systems in which an Abaqus input file gives its nodes (Abaqus Keywords Guide, *NODE and *SYSTEM).
#pragma once
#include <array>

#include "abaqus_deck.hpp"
#include "core/types.hpp"

namespace brunt::io {

/// The local Cartesian system of *SYSTEM.
struct DeckFrame {
  Vec3 origin = Vec3::Zero();
  std::array<Vec3, 3> axes{Vec3::UnitX(), Vec3::UnitY(), Vec3::UnitZ()};

  [[nodiscard]] Vec3 global(const Vec3& local) const {
    return origin + local[0] * axes[0] + local[1] * axes[1] + local[2] * axes[2];
  }
};

/// Of a *SYSTEM card: origin a and b on the x axis in the first line, c in the x-y plane in the second one. Without b a
/// translation; without c the z axis is the global one and the x axis is projected on the x-y plane; without data the
/// global system.
DeckFrame frame_of(const AbaqusDeck& deck, const DeckCard& card);

/// SYSTEM of a *NODE card.
enum class NodeSystem { cartesian, cylindrical, spherical };
NodeSystem node_system_of(const AbaqusDeck& deck, const DeckCard& card);

/// Cartesian coordinates of (x, y, z), (r, theta, z) or (r, theta, phi). Angles are in degrees; theta is about z from
/// x, phi is the elevation from the x-y plane (the plane phi = 0 of *NMAP is perpendicular to the polar axis).
Vec3 cartesian(NodeSystem system, const Vec3& given);

}  // namespace brunt::io
