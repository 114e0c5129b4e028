// SPDX-License-Identifier: Apache-2.0
// Generated bodies: division of their directions into elements, and round bodies.
#pragma once
#include <array>
#include <string_view>

#include "mesh/division.hpp"
#include "scene/input.hpp"
#include "scene/text/reader.hpp"

namespace brunt::scene {

/// Range of a direction. Sizes are not used if `high` is not above `low`.
struct Extent {
  double low = 0, high = 0;
  std::string_view what;   ///< the name of the direction, for messages
  bool even_only = false;  ///< no bias and no sizes
};

/// The keys `elements` and `bias`; after a fault the division remains uniform.
bool read_divisions(Section& body, std::span<const Extent> extents, std::span<mesh::Division> divisions,
                    std::string_view expected);

/// A mesh has 32-bit indices, so its numbers of nodes and corners are limited.
void demand_countable(Section& body, double nodes, double elements);

CylinderMesh read_cylinder(Section& body);
SphereMesh read_sphere(Section& body);
TubeMesh read_tube(Section& body);
TorusMesh read_torus(Section& body);

constexpr std::string_view part_name = "a name for the part";
constexpr Count at_least_one{1};

}  // namespace brunt::scene
