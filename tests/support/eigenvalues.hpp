// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <Eigen/Core>

namespace brunt::test {

/// Ascending eigenvalues of the symmetric part of a square matrix. Compiled once: Eigen's solver takes ten seconds.
[[nodiscard]] Eigen::VectorXd eigenvalues(const Eigen::Ref<const Eigen::MatrixXd>& A);

}  // namespace brunt::test
