// SPDX-License-Identifier: Apache-2.0
// Carriers of degrees of freedom. A contact point belongs to itself (three numbers: its mobility says all there is to
// say) or to a body of six. A body gives velocities to its points, v = V + omega x r with r = x - centre, takes their
// impulses as P = sum (p, r x p), and answers W P; enforcement asks no more.
#pragma once
#include <Eigen/Core>
#include <algorithm>
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
  std::span<const CarriedPoint> points;  ///< of this rank, each once, ascending
  std::span<const Carrier> bodies;       ///< of all ranks, the same bits on each; none: points carry themselves

  /// The body that carries a contact node; null where none does.
  [[nodiscard]] const Carrier* of(LocalIndex point) const {
    if (bodies.empty()) return nullptr;
    const auto found = std::ranges::lower_bound(points, point, {}, &CarriedPoint::point);
    if (found == points.end() || found->point != point) return nullptr;
    return &bodies[static_cast<std::size_t>(found->body)];
  }
};

/// Change of a point's velocity by an impulse on it: J W J^T, J = [1, -r x]. position: as the carrier's centre.
inline Mat3 answer_at(const Carrier& carrier, const Vec3& position) {
  const Vec3 r = position - carrier.centre;
  Eigen::Matrix<double, 3, 6> J = Eigen::Matrix<double, 3, 6>::Identity();
  J.rightCols<3>() << 0, r[2], -r[1], -r[2], 0, r[0], r[1], -r[0], 0;
  return J * carrier.mobility * J.transpose();
}

}  // namespace brunt::contact
