// SPDX-License-Identifier: Apache-2.0
#include "plane_program.hpp"

#include <algorithm>

#include "depth/sparse_program.hpp"

namespace brunt::depth {
namespace {

constexpr double feasible = 1e-12;  // of the radius

}  // namespace

PlaneProgram::PlaneProgram(const Standing& standing) : standing_(standing) {
  for (std::size_t k = 0; k < standing.assembly().members.size(); ++k)
    for (int c = 0; c < 3; ++c)
      if (const Vec3 axis = standing.member(k).basis.col(c); !axis.isZero(0)) unknowns_.push_back({k, axis});
}

bool PlaneProgram::solve(const std::vector<Plane>& planes, Pose& pose, std::vector<std::size_t>& proof) const {
  const std::size_t n = unknowns_.size();
  double most = 0;
  for (const Unknown& unknown : unknowns_) most = std::max(most, standing_.member(unknown.member).mass);
  std::vector<double> G(n * n, 0.0);
  for (std::size_t i = 0; i < n; ++i) G[i * n + i] = standing_.member(unknowns_[i].member).mass / most;
  SparseProgram program(G, std::vector<double>(n, 0.0));
  std::vector<SparseRow> rows;
  for (const Plane& plane : planes) {
    const MemberPair& pair = standing_.assembly().pairs[plane.pair];
    SparseRow& row = rows.emplace_back();
    row.bound = plane.bound;
    for (std::size_t i = 0; i < n; ++i) {
      const double along = unknowns_[i].axis.dot(plane.along);
      if (unknowns_[i].member == pair.a) row.add(static_cast<int>(i), along);
      if (unknowns_[i].member == pair.b) row.add(static_cast<int>(i), -along);
    }
  }
  const Outcome outcome = program.solve(rows, feasible * standing_.radius());
  proof.clear();
  if (outcome == Outcome::infeasible)
    for (const int i : program.active()) proof.push_back(static_cast<std::size_t>(i));
  if (outcome != Outcome::solved) return false;
  for (RigidMotion& motion : pose.motions) motion.shift.setZero();
  for (std::size_t i = 0; i < n; ++i) pose.motions[unknowns_[i].member].shift += program.x()[i] * unknowns_[i].axis;
  return true;
}

}  // namespace brunt::depth
