// SPDX-License-Identifier: Apache-2.0
// Which of two facets of one surface that meets itself is the slave.
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "core/types.hpp"

namespace brunt::contact {

/// The role of a facet; none: nothing faces it.
enum class FacetRole : std::uint8_t { none, slave, master };

/// Two facets that face each other; `slave` was the slave at the last evaluation. Facets are numbered in the order of
/// their keys.
struct FacingPair {
  LocalIndex slave = no_index, master = no_index;
  std::int32_t pressed = 0;  ///< 1: a row of the slave facet has a pressure
  double up = 0;             ///< component of the slave facet's normal in a direction common to all pairs

  friend bool operator<(const FacingPair& a, const FacingPair& b) {
    return a.slave < b.slave || (a.slave == b.slave && a.master < b.master);
  }
};

/// Whether the first facet is the slave of the pair. Of two facets that this question is put to in both orders, one is:
/// where the roles do not say which, the facet with the smaller number.
[[nodiscard]] inline bool is_slave(FacetRole role, FacetRole other_role, LocalIndex facet, LocalIndex other) {
  if (role == other_role) return facet < other;
  return role == FacetRole::slave || other_role == FacetRole::master;
}

/// Two-colouring of the graph of these pairs, such that facets that face each other have different roles if possible.
/// Slaves of pressed pairs remain slaves, so their pressures and frictional histories continue. From pressed pairs the
/// roles spread to the facets connected with them. In a component without pressure the side with the smaller mean edge
/// is the slave, of equal ones the side whose facets look up on average: zones that may grow together begin with the
/// same roles. If that does not decide it is the side of the facet with the smallest number. Pairs in any order; edge:
/// mean edge of each facet [length]. The result depends only on the set of pairs.
std::vector<FacetRole> roles_of_facets(std::vector<FacingPair> pairs, std::span<const double> edge);

/// The first pair whose facets have the same role, or a pair of no_index. Such a pair lies where three or another odd
/// number of walls meet, or between two contact zones that have grown together.
FacingPair undecided(std::span<const FacingPair> pairs, std::span<const FacetRole> roles);

}  // namespace brunt::contact
