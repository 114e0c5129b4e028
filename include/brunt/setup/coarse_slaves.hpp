// SPDX-License-Identifier: Apache-2.0
// Pairs of which the scene names the coarser side as the slave.
#pragma once
#include <span>
#include <vector>

#include "brunt/setup/start_rules.hpp"

namespace brunt::setup {

/// Medians of the longest edges, of the faces that are near the other part or fly towards it.
struct CoarseSlave {
  std::size_t slave = 0, master = 0;  ///< blocks
  double coarse = 0, fine = 0;        ///< edges of the slave, of the master [length]
};

/// Each pair that meets in one pass and whose named slave has faces with edges more than twice as long as the master's:
/// in between the slave's nodes nothing holds the master's, and no figure shows how deep they are. velocity: of each
/// node at the start; duration: of the run, may be infinite.
std::vector<CoarseSlave> coarse_slaves(const mesh::Mesh& mesh, const StartRules& rules, std::span<const Vec3> velocity,
                                       double duration);

}  // namespace brunt::setup
