// SPDX-License-Identifier: Apache-2.0
// Contact of a part with itself. All its exterior facets stand on both sides of one interface. Of two facets that face
// each other one is the slave: roles are chosen at the start of each step from what faces each other then.
#pragma once
#include <string>
#include <vector>

#include "comm/communicator.hpp"
#include "contact/mortar/colouring.hpp"
#include "core/ragged.hpp"
#include "core/types.hpp"

namespace brunt::implicit {

struct SelfContact {
  // of all facets of the part, in the order of their keys, the same on every rank
  std::vector<GlobalIndex> key;
  std::vector<double> edge;               ///< mean edge [length]
  std::vector<contact::FacetRole> roles;  ///< in the step
  // of this rank
  std::vector<LocalIndex> slave, master;  ///< numbers, among all, of the facets of MortarSurfaces
  Ragged<LocalIndex> never;       ///< for each facet of `slave`: numbers of those that it cannot meet, ascending
  contact::FacingPair undecided;  ///< a pair that could not have different roles
  bool told = false;              ///< a warning was given of such a pair

  /// Whether the first facet is the slave of these two, as numbers of MortarSurfaces, and may meet the second.
  [[nodiscard]] bool admits(LocalIndex of_slaves, LocalIndex of_masters) const;
  [[nodiscard]] LocalIndex number_of(GlobalIndex facet) const;
};

/// Warns once of each part in which facets that face each other have no different roles. origin: of the mesh [length].
/// Collective.
std::vector<std::string> warnings_of_roles(const comm::Communicator& ranks, const Vec3& origin,
                                           struct MortarContact& contact);

}  // namespace brunt::implicit
