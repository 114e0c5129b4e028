// SPDX-License-Identifier: Apache-2.0
// Carriers of degrees of freedom. A contact point either has its own three (described by its mobility) or belongs to a
// body with six. A body gives velocities to its points, v = V + omega x r with r = x - centre, receives their impulses
// as P = sum (p, r x p), and responds with W P; enforcement needs nothing else.
#pragma once
#include <Eigen/Core>
#include <algorithm>
#include <span>
#include <vector>

#include "core/types.hpp"

namespace brunt::contact {

/// Vector of a body: three components of translation, three of rotation about its centre, in space.
using Vec6 = Eigen::Matrix<double, 6, 1>;
using Mat6 = Eigen::Matrix<double, 6, 6>;

struct Carrier {
  Vec3 centre = Vec3::Zero();  ///< at t_n, measured as positions of contact nodes are
  Mat6 mobility =
      Mat6::Zero();          ///< W: (dV, domega) = W (impulse, moment); symmetric, zero along constrained directions
  Vec3 spin = Vec3::Zero();  ///< angular velocity predicted without contact [rad/time]
};

/// A contact node of a body: its own inverse mass is zero, and its predicted velocity is that of the body.
struct CarriedPoint {
  LocalIndex point = 0;  ///< contact node of this rank, a copy or not
  LocalIndex body = 0;
  bool owned = true;  ///< by this rank
};

/// Bodies that joints connect: an impulse on one of them moves all.
struct CoupledBodies {
  std::vector<LocalIndex> bodies;  ///< ascending
  Eigen::MatrixXd mobility;        ///< W of all, six rows a body; Carrier::mobility is its block of the body itself
  std::vector<Mat6> alone;         ///< of each body as if it had no joints: G W G^T is at most that of these
};

struct Carriers {
  std::span<const CarriedPoint> points;  ///< of this rank, each once, ascending
  std::span<const Carrier> bodies;       ///< of all ranks, the same bits on each; none: points carry themselves
  std::span<const CoupledBodies> coupled{};

  /// The body of a contact node; null for other nodes.
  [[nodiscard]] const Carrier* of(LocalIndex point) const {
    if (bodies.empty()) return nullptr;
    const auto found = std::ranges::lower_bound(points, point, {}, &CarriedPoint::point);
    if (found == points.end() || found->point != point) return nullptr;
    return &nth(bodies, found->body);
  }

  /// The bodies that joints connect with this one; null without joints.
  [[nodiscard]] const CoupledBodies* group_of(LocalIndex body) const {
    const auto has_it = [&](const CoupledBodies& group) { return std::ranges::binary_search(group.bodies, body); };
    const auto found = std::ranges::find_if(coupled, has_it);
    return found == coupled.end() ? nullptr : &*found;
  }

  /// The mobility of a body without its joints.
  [[nodiscard]] const Mat6& alone(LocalIndex body) const {
    const CoupledBodies* group = group_of(body);
    if (group == nullptr) return nth(bodies, body).mobility;
    return nth(group->alone, std::ranges::lower_bound(group->bodies, body) - group->bodies.begin());
  }
};

/// Change of a point's velocity by an impulse on it: J W J^T, J = [1, -r x]. position: measured as the carrier's
/// centre.
inline Mat3 answer_at(const Carrier& carrier, const Vec3& position) {
  const Vec3 r = position - carrier.centre;
  Eigen::Matrix<double, 3, 6> J = Eigen::Matrix<double, 3, 6>::Identity();
  J.rightCols<3>() << 0, r[2], -r[1], -r[2], 0, r[0], r[1], -r[0], 0;
  return J * carrier.mobility * J.transpose();
}

}  // namespace brunt::contact
