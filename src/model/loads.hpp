// SPDX-License-Identifier: Apache-2.0
// Forces on the bodies: constant during a run, but for their curves over time.
#pragma once
#include <limits>
#include <vector>

#include "core/types.hpp"
#include "mesh/local_mesh.hpp"
#include "model/curve.hpp"

namespace brunt::model {

struct PressureLoad {
  std::vector<mesh::ExteriorFace> faces;
  double value = 0;  ///< [stress]; positive values act inwards
  Curve curve;
};

/// Forces of constant direction that do not follow the motion.
struct DeadForce {
  Vec3 value = Vec3::Zero();   ///< of each node [force], of all together [force], or for each area [stress]
  Vec3 moment = Vec3::Zero();  ///< of each node, which turns [moment]; of `each_node` alone
  enum class Kind { each_node, total, traction } kind = Kind::each_node;
};
struct DeadLoad : DeadForce {
  Curve curve;
  std::vector<mesh::ExteriorFace> faces;  ///< over which a total or a traction is spread
  std::vector<LocalIndex> nodes;          ///< ascending; of faces they are found by time::link_ranks, with the weights
  std::vector<double> weight;             ///< factor of `value` at each of `nodes`: 1, share of the area, or area
};

/// The drag -alpha m v on every node. It acts on forces of t_n with from <= t_n < to.
struct Damping {
  double alpha = 0;                                               ///< [1/time]
  double from = 0, to = std::numeric_limits<double>::infinity();  ///< [time]
};

struct Loads {
  Vec3 gravity = Vec3::Zero();  ///< [length/time^2]
  Curve gravity_curve;
  Damping damping;
  std::vector<PressureLoad> pressure;
  std::vector<DeadLoad> dead;
};

}  // namespace brunt::model
