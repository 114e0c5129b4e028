// SPDX-License-Identifier: Apache-2.0
// What a scene asks of one mortar interface: two blocks that meet segment to segment.
#pragma once
#include <cstdint>
#include <string>

namespace brunt::contact {

/// Functions that the multipliers of a slave facet are spanned by.
enum class Multiplier : std::int8_t {
  dual,     ///< psi = D M^-1 N, biorthogonal to the hats over the covered part of each facet
  standard  ///< the slave's hat functions
};

struct MortarPair {
  std::int32_t slave = 0, master = 0;  ///< blocks
  bool choose_slave = true;            ///< the block with the finer facets is the slave, whichever stands first
  Multiplier multiplier = Multiplier::dual;
  enum class Enforce : std::int8_t {
    lagrange,  ///< exact, by the primal-dual active set
    penalty    ///< a pressure in proportion to the penetration
  } enforce = Enforce::lagrange;
  bool consistent = false;  ///< forces are the gradient of the weighted gaps
  bool edges = false;       ///< sharp edges split the surfaces, and their nodes have rows of their own
  double friction = 0;      ///< Coulomb's coefficient
  bool tied = false;
  std::string entry{};  ///< where it was asked for, as messages begin
};

}  // namespace brunt::contact
