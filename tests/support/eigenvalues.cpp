// SPDX-License-Identifier: Apache-2.0
#include "support/eigenvalues.hpp"

#include <Eigen/Eigenvalues>

namespace brunt::test {

Eigen::VectorXd eigenvalues(const Eigen::Ref<const Eigen::MatrixXd>& A) {
  const Eigen::MatrixXd symmetric = 0.5 * (A + A.transpose());
  return Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(symmetric, Eigen::EigenvaluesOnly).eigenvalues();
}

}  // namespace brunt::test
