// SPDX-License-Identifier: Apache-2.0
// The optimal small motion of all members under the linear conditions of near pairs.
//
// Unknowns: the components of tau_k along the admitted directions, and rho_k omega_k where the member turns, each at
// most `trust`, rho_k = sqrt(tr J_k/2). A condition n . (tau_a + omega_a x r_a - tau_b - omega_b x r_b) >= bound has
// at most twelve coefficients. The program is solved with the conditions that have been violated so far; those of a
// pair join one by one, the most violated first.
#pragma once
#include <array>
#include <optional>

#include "assembly_pose.hpp"
#include "depth/near_pairs.hpp"
#include "depth/sparse_program.hpp"

namespace brunt::depth {

/// Of two members: as near_pairs.hpp, with both moving. Vectors in the common axes.
struct AssemblyCondition {
  std::size_t pair = 0;
  Vec3 normal = Vec3::Zero();                       ///< from b to a
  Vec3 arm_a = Vec3::Zero(), arm_b = Vec3::Zero();  ///< from the members' centroids to the nearest points [length]
  double distance = 0;                              ///< [length]
  double bound = 0;                                 ///< [length]
  LocalIndex triangle_a = no_index, triangle_b = no_index;
};

struct SmallMotion {
  std::vector<Vec3> tau, omega;  ///< of each member [length], [rad]
  double size = 0;               ///< the largest unknown [length]
};

class AssemblyStep {
 public:
  AssemblyStep(const Standing& standing, const Pose& pose);

  /// None if the conditions are contradictory within the trust region. predicted: length of the linearised motion.
  [[nodiscard]] std::optional<SmallMotion> solve(std::span<const AssemblyCondition> conditions, double trust,
                                                 double& predicted);

 private:
  [[nodiscard]] SmallMotion motion_of(const std::vector<double>& x) const;
  [[nodiscard]] SparseRow row_of(const AssemblyCondition& condition) const;

  const Standing& standing_;
  struct Place {
    int first = 0, shifts = 0;  // unknowns of translation from `first` on; those of rotation follow
    bool turns = false;
    double rho = 1;
    Eigen::Matrix<double, 3, 3> along;  // the first `shifts` columns
  };
  std::vector<Place> places_;
  int count_ = 0;
  double constant_ = 0;  // of the objective: length^2 at x = 0
  std::vector<double> G_, g_;
};

/// Left side of the condition for a small motion [length].
[[nodiscard]] double approach(const Standing& standing, const AssemblyCondition& condition, const SmallMotion& motion);

}  // namespace brunt::depth
