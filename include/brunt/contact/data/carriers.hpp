// SPDX-License-Identifier: Apache-2.0
// Carriers of degrees of freedom. A contact point belongs to itself (three numbers: its mobility says all there is to
// say) or to a body of six. A body gives velocities to its points, v = V + omega x r with r = x - centre, takes their
// impulses as P = sum (p, r x p), and answers W P; enforcement asks no more.
#pragma once
#include <Eigen/Core>
#include <span>

#include "brunt/core/types.hpp"

namespace brunt::contact {

/// Of a body: three of translation, three of rotation about its centre, in space.
using Vec6 = Eigen::Matrix<double, 6, 1>;
using Mat6 = Eigen::Matrix<double, 6, 6>;

struct Carrier {
  Vec3 centre = Vec3::Zero();    ///< at t_n, measured as positions of contact nodes are
  Mat6 mobility = Mat6::Zero();  ///< W: (dV, domega) = W (impulse, moment); symmetric, zero along what is held
};

/// A contact node that a body carries: its own inverse mass is zero, and its predicted velocity that of the body.
struct CarriedPoint {
  LocalIndex point = 0;  ///< contact node of this rank, a copy or not
  LocalIndex body = 0;
  bool owned = true;  ///< by this rank
};

struct Carriers {
  std::span<const CarriedPoint> points;  ///< of this rank, each once
  std::span<const Carrier> bodies;       ///< of all ranks, the same bits on each; none: points carry themselves
};

}  // namespace brunt::contact
