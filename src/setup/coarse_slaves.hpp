// SPDX-License-Identifier: Apache-2.0
// Pairs for which the scene names the coarser side as the slave.
#pragma once
#include <span>
#include <vector>

#include "setup/start_rules.hpp"

namespace brunt::setup {

/// Medians of the longest edges of the faces that are near the other part or move towards it.
struct CoarseSlave {
  std::size_t slave = 0, master = 0;  ///< blocks
  double coarse = 0, fine = 0;        ///< edges of the slave, of the master [length]
};

/// Each pair with one-pass contact whose named slave has faces with edges more than twice as long as the master's.
/// Between the nodes of such a slave nothing constrains the nodes of the master, and no result shows their penetration.
/// velocity: of each node at the start; duration: of the run, may be infinite.
std::vector<CoarseSlave> coarse_slaves(const mesh::Mesh& mesh, const StartRules& rules, std::span<const Vec3> velocity,
                                       double duration);

}  // namespace brunt::setup
