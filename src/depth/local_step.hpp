// SPDX-License-Identifier: Apache-2.0
// The best small motion under the linear conditions of close pairs.
//
// Unknowns xi = (tau, rho omega), rho = sqrt(tr J/2), |xi_i| <= trust along the principal axes of A, so that steps do
// not depend on those of its file: the centroid moves by tau, and the body turns by omega about it, dT = tau and dv =
// (w omega + omega x v)/2.
//   object norm   minimise |T + tau|^2 + 4 (v + dv)^T J (v + dv): a quadratic program in six unknowns
//   displacement  minimise s^2/2 + eps |xi|^2/2, s >= e_j . (d_j + tau + omega x a_j): seven unknowns; the cutting
//                 directions e_j are added at the vertex that moves most until none moves more than s
//   translation   minimise |T + tau|^2 over the admitted directions: three unknowns
// eps makes the program strictly convex and vanishes as steps become small (proximal point).
#pragma once
#include <span>
#include <vector>

#include "depth/near_pairs.hpp"
#include "depth/quadratic_program.hpp"

namespace brunt::depth {

struct LocalProblem {
  Metric metric = Metric::displacement;
  double trust = 0;               ///< [length]
  double accuracy = 1e-9;         ///< of the least DISP in the model [length]
  Mat3 basis = Mat3::Identity();  ///< of admitted translations: orthonormal columns, zero ones for those forbidden
  Mat3 axes = Mat3::Identity();   ///< of the trust region: orthonormal columns
};

struct LocalStep {
  RigidMotion motion;                             ///< after the step, its rotation exact
  Vec3 tau = Vec3::Zero(), omega = Vec3::Zero();  ///< [length], [rad]
  double size = 0;                                ///< the greatest |xi_i| along the axes of the trust region [length]
  double predicted = 0;                           ///< length of the linearised motion
  bool solved = false;
};

/// Work arrays that keep their capacity.
class LocalSolver {
 public:
  [[nodiscard]] LocalStep solve(const MetricShape& shape, const RigidMotion& motion,
                                std::span<const NearCondition> conditions, const LocalProblem& problem);

 private:
  LocalStep shift_only(const RigidMotion& motion, std::span<const NearCondition> conditions,
                       const LocalProblem& problem);
  LocalStep in_object_norm(const MetricShape& shape, const RigidMotion& motion,
                           std::span<const NearCondition> conditions, const LocalProblem& problem);
  LocalStep in_displacement(const MetricShape& shape, const RigidMotion& motion,
                            std::span<const NearCondition> conditions, const LocalProblem& problem);
  std::vector<Row<3>> rows3_;
  std::vector<Row<6>> rows6_;
  std::vector<Row<7>> rows7_;
};

}  // namespace brunt::depth
