// SPDX-License-Identifier: Apache-2.0
// Bodies that joints connect, as one system: G of all its rows, the mobility W of its bodies, and the impulses q of the
// joints that give their rows a wanted change of rate,
//   G W G^T q = change.
// The rows are scaled to a unit diagonal and factorised with pivots; redundant rows (hinges of a closed chain) share
// their impulse, that of least norm, and rows that nothing can move have none. Impulses P on the bodies are answered by
//   W_c P,  W_c = W - W G^T (G W G^T)^+ G W,
// which opens no joint: bodies in contact feel what hangs on them.
#pragma once
#include <Eigen/QR>
#include <span>
#include <vector>

#include "core/types.hpp"
#include "rigid/joint.hpp"

namespace brunt::rigid {

using Mat6 = Eigen::Matrix<double, 6, 6>;
using Vec6 = Eigen::Matrix<double, 6, 1>;

/// A joint of a group.
struct JointPlace {
  Joint joint;
  LocalIndex number = 0;                               ///< in the model's list
  std::array<LocalIndex, 2> body{no_index, no_index};  ///< in the group; no_index: the ground
  LocalIndex first_row = 0;
};

/// Constant in a run.
struct JointGroup {
  std::vector<LocalIndex> bodies;  ///< of the model, ascending
  std::vector<JointPlace> joints;
  LocalIndex rows = 0;
};

/// The poses of the two sides of a joint.
[[nodiscard]] std::array<Pose, 2> sides_of(const JointPlace& place, std::span<const Pose> pose);

/// Groups of bodies that joints connect (the ground connects none), in the order of their first bodies. body: of each
/// joint, in the model, no_index for the ground.
[[nodiscard]] std::vector<JointGroup> group_bodies(std::span<const Joint> joints,
                                                   std::span<const std::array<LocalIndex, 2>> body, LocalIndex bodies);

/// A group at one place, factorised.
class JointSystem {
 public:
  /// pose, mobility: of the group's bodies.
  void form(const JointGroup& group, std::span<const Pose> pose, std::span<const Mat6> mobility);

  /// Gaps of the rows at a place [length, sine].
  [[nodiscard]] static Eigen::VectorXd gaps(const JointGroup& group, std::span<const Pose> pose);

  /// q for this change of the rates of the rows [momentum; of the axis mass length^2/time].
  [[nodiscard]] Eigen::VectorXd impulses(const Eigen::VectorXd& change) const;
  /// G^T q: on each body, six numbers.
  [[nodiscard]] Eigen::VectorXd on_bodies(const Eigen::VectorXd& impulses) const {
    return slope_.transpose() * impulses;
  }
  /// G v of the velocities of the bodies, six numbers each.
  [[nodiscard]] Eigen::VectorXd rates(const Eigen::VectorXd& velocity) const { return slope_ * velocity; }
  /// W P, without the joints.
  [[nodiscard]] Eigen::VectorXd moved(const Eigen::VectorXd& impulse) const { return mobility_ * impulse; }
  /// W_c.
  [[nodiscard]] Eigen::MatrixXd coupled_mobility() const;
  /// How many rows the others determine.
  [[nodiscard]] LocalIndex redundant() const { return static_cast<LocalIndex>(slope_.rows() - solver_.rank()); }

 private:
  Eigen::MatrixXd slope_, mobility_, scaled_;
  Eigen::VectorXd scale_;  ///< 1/sqrt of the diagonal of G W G^T; 0 for rows that nothing can move
  Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> solver_;
};

}  // namespace brunt::rigid
