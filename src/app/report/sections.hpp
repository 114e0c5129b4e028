// SPDX-License-Identifier: Apache-2.0
// The force of the material in front of a section on the nodes of the section: the sum of the corner forces of its
// elements there.
#pragma once
#include <array>
#include <vector>

#include "app/state/prepared.hpp"

namespace brunt::app {

struct Section {
  std::vector<std::vector<model::WatchedCorner>> corners;  ///< by block, of this rank's elements
  std::vector<LocalIndex> nodes;                           ///< of the section, owned by this rank
  std::optional<Vec3> about;                               ///< of the moment, in the scene's coordinates
};
/// Of a plane: corners on its nodes of elements that reach in front of it. Of a set: of all elements of the parts.
Section find_section(const Prepared& run, std::size_t probe);

/// Force and moment at t_n, between evaluate and advance; the moment about `about`, else about the mean of the current
/// positions of the section's nodes. Sums are exact. Collective.
std::array<Vec3, 2> section_force(const Prepared& run, const Section& section);

}  // namespace brunt::app
